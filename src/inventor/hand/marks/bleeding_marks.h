// Marks the ends at which vessels bleed, for an instrument that can stop the bleeding: a ring round
// each end. The more the end bleeds, the larger is its ring.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "blood/bleeding.h"
#include "inventor/hand/marks/line_marks.h"

namespace resect {

inline constexpr double kLeastMarkedFlow = 3e-9;  // m^3/s: ends that bleed less have no ring

// A ring for each end. chosen: the point (world, m) at which the instrument in hand works when it
// is pressed; the ring of the end nearest to this point is white and double. towardsEye: direction
// that the rings face, unit.
std::vector<MarkLine> bleedingRings(std::span<const BleedingEnd> ends,
                                    const std::optional<Vec3>& chosen, const Vec3& towardsEye);

}  // namespace resect
