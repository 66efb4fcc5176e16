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

std::optional<double> pathInefficiency(const Track& track, std::span<const SampleRange> movements) {
  double length = 0, distance = 0;
  for (const SampleRange& range : movements) {
    length += pathLength(std::span(track.tip).subspan(range.first, range.count()));
    distance += (track.tip[range.last] - track.tip[range.first]).norm();
  }
  if (!(distance > 0)) return {};
  return 100 * (length / distance - 1);
}

}  // namespace resect
