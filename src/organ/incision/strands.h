// Severs strands: tissue inside the surface that joins two particles although no bond joins them.
#pragma once

#include <cstdint>
#include <span>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Opens the surface where bonds were cut or torn. Each grid node has an owner: the particle that is
// the fewest whole edges away (organ/incision/node_owners.h). A whole edge is severed if its two
// nodes have different owners, and these owners are neither bonded to each other nor both bonded to
// a third particle. So afterwards tissue joins particles only where bonds do. `parted`: bonds
// severed since partStrands() was last called. `near`: particles near a blade that has cut since
// then. Call before SeveredEdges::update(). Returns the number of edges severed. Cost: proportional
// to the number of nodes near the cut and round the bonds.
std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted,
                         std::span<const std::int64_t> near = {});

}  // namespace resect
