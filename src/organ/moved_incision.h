// How is an incision made in tissue that has moved? The blade is met where the tissue is now.
#pragma once

#include "collision/swept_blade.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Cuts along the blade, in world space as the tissue is; `nearCells`: particles near the blade. The
// surface follows with updateSurface(). Returns the number of grid edges severed. Cost: some 10 us
// per brick near the blade.
std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells);

// Parts the surface wherever bonds are gone, cut or torn. Each node of the grid goes with the
// particle that is the fewest whole edges away; a whole edge between nodes that go with particles
// which hold each other neither by a bond nor over a third particle is severed. So no strand of
// surface joins particles that nothing else joins. `parted`: the bonds that went since the last
// call; `near`: particles near a blade that has cut since. Returns the number of edges severed.
// Cost: some 0.5 us a node.
std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted,
                         std::span<const std::int64_t> near = {});

}  // namespace resect
