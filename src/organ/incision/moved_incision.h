// Incisions in tissue that has moved.
#pragma once

#include "collision/swept_blade.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Severs the grid edges that the blade crosses. The blade is given in the world; it is tested
// against the present positions of the tissue. `nearCells`: particles near the blade; without any,
// nothing is cut. The surface follows at the next updateSurface(). Returns the number of grid edges
// severed. Cost: proportional to the particles near the blade, and to the grid nodes of the lattice
// cubes that the blade may meet. (A lattice cube lies between eight neighbouring cell centres.)
std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells);

}  // namespace resect
