#include "tools/parts/bipolar_part.h"

#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kGrasps = 0.9;   // squeeze from which current flows
constexpr double kReach = 0.005;  // m: the grasped tissue, and a little
constexpr double kPower = 60;     // W

}  // namespace

void BipolarPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (touch.way.to.squeeze < kGrasps) return;
  if (const auto place = restPlace(touch.organ, touch.tissue, touch.way.to.pose * touch.model.tip))
    edits.push_back(touch.edit(Heat{*place, kReach, kPower}));
}

}  // namespace resect
