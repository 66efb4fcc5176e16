// Severs strands: grid edges between particles that no bond holds together any more.
#pragma once

#include <cstdint>
#include <span>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Parts the surface wherever bonds are gone, cut or torn. Each grid node has an owner, the particle
// that is the fewest whole edges away (organ/incision/node_owners.h). A whole edge is severed if
// the owners of its two nodes are neither bonded nor both bonded to a third particle. So no strand
// of surface joins particles that nothing else joins. `parted`: bonds severed since the last call;
// `near`: particles near a blade that has cut since the last call. Call before
// SeveredEdges::update(). Returns the number of edges severed. Cost: proportional to the nodes near
// the cut and round the bonds.
std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted,
                         std::span<const std::int64_t> near = {});

}  // namespace resect
