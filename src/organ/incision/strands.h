// Where bonds are gone, no strand of surface may hold pieces together.
#pragma once

#include <cstdint>
#include <span>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Parts the surface wherever bonds are gone, cut or torn. Each node of the grid goes with the
// particle that is the fewest whole edges away; a whole edge between nodes that go with particles
// which hold each other neither by a bond nor over a third particle is severed. So no strand of
// surface joins particles that nothing else joins. `parted`: the bonds that went since the last
// call; `near`: particles near a blade that has cut since; called before the severed edges'
// update(). Returns the number of edges severed. Cost: in proportion to the
// nodes near the cut and round the bonds.
std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted,
                         std::span<const std::int64_t> near = {});

}  // namespace resect
