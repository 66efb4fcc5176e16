// Marks where vessels bleed, for a hand that is to stop it: a ring round each end, the larger the
// more it bleeds.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "blood/bleeding.h"
#include "inventor/hand/marks/line_marks.h"

namespace resect {

inline constexpr double kLeastMarkedFlow = 3e-9;  // m^3/s: ends that bleed less have no ring

// A ring for each end. chosen: where the instrument in hand works when it is pressed; the ring of
// the end nearest to it is white and double. towardsEye: unit; the rings face it.
std::vector<MarkLine> bleedingRings(std::span<const BleedingEnd> ends,
                                    const std::optional<Vec3>& chosen, const Vec3& towardsEye);

}  // namespace resect
