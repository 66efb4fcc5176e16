// Marks the open ends of vessels that bleed. Each end gets a ring. The more an end bleeds, the
// larger is its ring. The marks are meant for instruments that can stop bleeding.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "blood/bleeding.h"
#include "inventor/hand/marks/line_marks.h"

namespace resect {

// Least flow out of an end, m^3/s. The caller of bleedingRings() leaves out ends that bleed less.
inline constexpr double kLeastMarkedFlow = 3e-9;

// The rings of all `ends`. chosen: the point at which the instrument in hand works when it is
// pressed; world, m. If the end that is nearest to this point is at most 6 mm away, the ring of
// this end is white and double. towardsEye: direction that the rings face, unit.
std::vector<MarkLine> bleedingRings(std::span<const BleedingEnd> ends,
                                    const std::optional<Vec3>& chosen, const Vec3& towardsEye);

}  // namespace resect
