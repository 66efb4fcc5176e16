#include "tools/parts/suction_part.h"

#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kSuctionReach = 0.010;  // m: round the mouth
constexpr double kRate = 25e-6;          // m^3/s: of blood with air

}  // namespace

void SuctionPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (touch.organNumber != 0) return;  // once a frame: it takes blood wherever it is
  edits.push_back(touch.edit(Suction{touch.way.to.pose * touch.model.tip, kSuctionReach, kRate}));
}

}  // namespace resect
