// Severs strands. A strand is tissue inside the surface that joins two particles although no bond
// joins them.
#pragma once

#include <cstdint>
#include <span>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Opens the surface where bonds were cut or torn. A whole edge is an edge of the colour field's
// grid (a line between neighbouring nodes) that is not severed. Each grid node has an owner, the
// nearest particle along whole edges (organ/incision/node_owners.h). A whole edge stays whole if
// the owners of its two nodes are the same particle, are bonded to each other, or are both bonded
// to a third particle. Otherwise it is severed. So afterwards tissue joins particles only where
// bonds join them. `parted`: bonds severed since the last call of partStrands(). `near`: particles
// near a blade that has cut since that call. Call before SeveredEdges::update(). Returns the number
// of edges severed. Cost: proportional to the number of nodes near the cut and round the bonds.
std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted,
                         std::span<const std::int64_t> near = {});

}  // namespace resect
