#include "skills/metrics/movements.h"

#include "skills/metrics/path.h"

namespace resect {

std::vector<SampleRange> movements(std::span<const double> speed, double interval,
                                   const MovementRule& rule) {
  std::vector<SampleRange> ranges;
  bool moving = false;
  std::size_t changed = 0;  // first sample of a state that is not `moving`, while there is one
  std::size_t other = 0;    // samples since then
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if ((speed[i] > rule.threshold) == moving) {
      other = 0;
      continue;
    }
    if (other++ == 0) changed = i;
    if (double(other) * interval <= rule.leastTime) continue;
    moving = !moving;
    other = 0;
    if (moving)
      ranges.push_back({changed, changed});
    else
      ranges.back().last = changed - 1;
  }
  if (moving) ranges.back().last = speed.size() - 1;
  return ranges;
}

void addWays(Ways& ways, const Track& track, std::span<const SampleRange> movements) {
  for (const SampleRange& range : movements) {
    ways.length += pathLength(std::span(track.tip).subspan(range.first, range.count()));
    ways.distance += (track.tip[range.last] - track.tip[range.first]).norm();
  }
}

std::optional<double> pathInefficiency(const Ways& ways) {
  if (!(ways.distance > 0)) return {};
  return 100 * (ways.length / ways.distance - 1);
}

}  // namespace resect
