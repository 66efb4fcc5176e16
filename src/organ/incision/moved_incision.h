// Incisions in tissue that has moved.
#pragma once

#include "collision/swept_blade.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Cuts along the blade, which is given in the world, where the tissue is now. `nearCells`:
// particles near the blade. The surface follows at the next updateSurface(). Returns the number of
// grid edges severed. Cost: proportional to the particles near the blade and to the nodes of the
// lattice cubes that the blade may meet.
std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells);

}  // namespace resect
