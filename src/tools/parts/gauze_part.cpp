#include "tools/parts/gauze_part.h"

#include <numbers>

#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kGauzeReach = 0.018;  // m: half the side of a folded swab, and a little
constexpr double kSoaks = 4e-6;        // m^3/s (estimate); a nurse hands a fresh swab in time
// Of still tissue no force is known: a hand presses as hard as stops a vein.
constexpr double kUsual = 3;  // N

}  // namespace

void GauzePart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (touch.organNumber != 0) return;  // once a frame: it is the same for all organs
  const double force = touch.tissue.moves() ? touch.force : kUsual;
  const double area = std::numbers::pi * kGauzeReach * kGauzeReach;
  edits.push_back(
      touch.edit(Press{touch.way.to.pose * touch.model.tip, kGauzeReach, force / area, kSoaks}));
}

}  // namespace resect
