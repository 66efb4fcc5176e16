// Marks the ends at which vessels bleed, for an instrument that can stop them: a ring round each
// end, which is larger the more the end bleeds.
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
