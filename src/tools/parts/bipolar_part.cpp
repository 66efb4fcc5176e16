#include "tools/parts/bipolar_part.h"

#include "tools/bleeding_end.h"
#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kBipolarReach = 0.005;  // m: the grasped tissue, and a little
constexpr double kPower = 60;            // W

}  // namespace

void BipolarPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (touch.way.to.squeeze < kBipolarCloses) return;
  const Vec3 tip = touch.way.to.pose * touch.model.tip;
  std::optional<Vec3> place = restPlace(touch.organ, touch.tissue, tip);
  if (const auto end = bleedingEndNear(touch.organ, touch.tissue, tip, kBipolarTakes,
                                       [](double radius) { return radius <= kWidestSealed; }))
    place = end->rest;
  if (place) edits.push_back(touch.edit(Heat{*place, kBipolarReach, kPower}));
}

}  // namespace resect
