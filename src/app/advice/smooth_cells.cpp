#include "app/advice/smooth_cells.h"

#include <algorithm>
#include <cmath>

namespace resect {

int smoothCells(const LiveState& state, double frameRate, double cell) {
  constexpr double kSlow = 0.9, kReserve = 1.1;
  constexpr int kSides[] = {4, 5, 6, 8, 10, 12, 15, 20};  // mm
  const double factor = state.times.realTimeFactor;
  if (state.showing || !state.moves || factor >= kSlow || state.times.median < kSlow / frameRate)
    return 0;
  const double wanted = 1e3 * cell * std::pow(kReserve / std::max(factor, 1e-3), 0.25);
  const auto* side = std::ranges::find_if(kSides, [&](int mm) { return mm >= wanted; });
  return side == std::end(kSides) ? 0 : *side;
}

}  // namespace resect
