#include "tools/parts/bipolar_part.h"

#include "tools/bleeding_end.h"
#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kGrasps = 0.9;          // squeeze from which current flows
constexpr double kBipolarReach = 0.005;  // m: the grasped tissue, and a little
constexpr double kPower = 60;            // W
constexpr double kTakes = 0.006;         // m: a bleeding end so near the tips is taken between them

}  // namespace

void BipolarPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (touch.way.to.squeeze < kGrasps) return;
  const Vec3 tip = touch.way.to.pose * touch.model.tip;
  std::optional<Vec3> place = restPlace(touch.organ, touch.tissue, tip);
  if (const auto end = bleedingEndNear(touch.organ, touch.tissue, tip, kTakes,
                                       [](double radius) { return radius <= kWidestSealed; }))
    place = end->rest;
  if (place) edits.push_back(touch.edit(Heat{*place, kBipolarReach, kPower}));
}

}  // namespace resect
