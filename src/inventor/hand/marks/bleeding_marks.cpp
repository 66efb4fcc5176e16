#include "inventor/hand/marks/bleeding_marks.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr double kSmallest = 0.0018, kLargest = 0.0065;  // m
constexpr double kSame = 0.006;           // m: so far tissue may have moved since an end was chosen
constexpr double kFlowOfLargest = 10e-6;  // m^3/s: 600 ml/min
const Vec3f kColour(1.0f, 0.85f, 0.2f);   // is told from blood by colour-blind people too
const Vec3f kChosen(1.0f, 1.0f, 1.0f);

}  // namespace

std::vector<MarkLine> bleedingRings(std::span<const BleedingEnd> ends,
                                    const std::optional<Vec3>& chosen, const Vec3& towardsEye) {
  const BleedingEnd* nearest = nullptr;
  for (const BleedingEnd& end : ends) {
    if (!chosen || (end.place - *chosen).norm() > kSame) continue;
    if (!nearest || (end.place - *chosen).norm() < (nearest->place - *chosen).norm())
      nearest = &end;
  }
  std::vector<MarkLine> rings;
  for (const BleedingEnd& end : ends) {
    const double share = std::min(1.0, std::cbrt(std::abs(end.flow) / kFlowOfLargest));
    const double radius = kSmallest + share * (kLargest - kSmallest);
    const bool goesThere = &end == nearest;
    rings.push_back({goesThere ? kChosen : kColour, circle(end.place, radius, towardsEye)});
    if (goesThere) rings.push_back({kChosen, circle(end.place, 1.5 * radius, towardsEye)});
  }
  return rings;
}

}  // namespace resect
