// How is an incision made in tissue that has moved? The blade is met where the tissue is now.
#pragma once

#include "collision/swept_blade.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Cuts along the blade, in world space as the tissue is, be it where it was at rest; `nearCells`:
// particles near the blade. The surface follows with updateSurface(). Returns the number of grid
// edges severed. Cost: in proportion to the particles near the blade, and to the nodes of the cubes
// that it may meet.
std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells);

}  // namespace resect
