#include "tools/parts/aspirator_part.h"

#include <algorithm>
#include <optional>

#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kSpares = 0.5e-3;      // m: radius of vessels that stay
constexpr double kSucksWithin = 0.005;  // m
constexpr double kRate = 8e-6;          // m^3/s: of blood

}  // namespace

double aspiratorReach(double spacing) {
  constexpr double kReach = 0.0048, kReachCells = 0.6;  // m; spacings
  return std::max(kReach, kReachCells * spacing);
}

void AspiratorPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const Vec3 tip = touch.way.to.pose * touch.model.tip,
             from = touch.way.from.pose * touch.model.tip;
  if (touch.organNumber == 0) edits.push_back(touch.edit(Suction{tip, kSucksWithin, kRate}));
  const double spacing = touch.organ.rest.lattice.spacing.x(), reach = aspiratorReach(spacing);
  // What lies between the tip and the handle goes too: no thin lip hangs over the groove.
  for (const double back : {0.0, reach}) {
    const auto at = [&](const Pose& pose, const Vec3& place) {
      return restPlace(touch.organ, touch.tissue,
                       place + back * (pose.rotation * touch.model.axis));
    };
    const std::optional<Vec3> to = at(touch.way.to.pose, tip);
    if (!to) return;
    // Tissue that has just come to the tip is carved at the tip only: where it lies at rest, the
    // way of the tip may lead through other tissue.
    const std::optional<Vec3> before = at(touch.way.from.pose, from);
    const bool together = before && (*before - *to).norm() <= (from - tip).norm() + spacing;
    edits.push_back(touch.edit(Carve{{together ? *before : *to, *to, reach}, kSpares}));
  }
}

}  // namespace resect
