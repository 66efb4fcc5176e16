#include "tools/parts/aspirator_part.h"

#include <algorithm>
#include <optional>

#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kReach = 0.0048;       // m: beyond which tissue is left alone
constexpr double kReachCells = 0.6;     // of the spacing, in a lattice coarser than 8 mm
constexpr double kSpares = 0.5e-3;      // m: radius of vessels that stay
constexpr double kSucksWithin = 0.005;  // m
constexpr double kRate = 8e-6;          // m^3/s: of blood

}  // namespace

void AspiratorPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const Vec3 tip = touch.way.to.pose * touch.model.tip,
             from = touch.way.from.pose * touch.model.tip;
  if (touch.organNumber == 0) edits.push_back(touch.edit(Suction{tip, kSucksWithin, kRate}));
  const std::optional<Vec3> to = restPlace(touch.organ, touch.tissue, tip);
  if (!to) return;
  const double spacing = touch.organ.rest.lattice.spacing.x();
  // Tissue that has just come to the tip is carved at the tip only: where it lies at rest, the way
  // of the tip may lead through other tissue.
  const std::optional<Vec3> before = restPlace(touch.organ, touch.tissue, from);
  const bool together = before && (*before - *to).norm() <= (from - tip).norm() + spacing;
  edits.push_back(touch.edit(
      Carve{{together ? *before : *to, *to, std::max(kReach, kReachCells * spacing)}, kSpares}));
}

}  // namespace resect
