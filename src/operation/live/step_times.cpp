#include "operation/live/step_times.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace resect {

LastSecond::LastSecond(double frameRate) : frameRate_(frameRate) {}

void LastSecond::keep(std::vector<double>& values, double value) const {
  const auto most = std::size_t(std::ceil(frameRate_));
  if (values.size() >= most) values.erase(values.begin(), values.end() - std::ptrdiff_t(most) + 1);
  values.push_back(value);
}

void LastSecond::add(const StageClock& clock, double arrival) {
  laps_.resize(clock.stages().size());
  double step = 0;
  for (std::size_t s = 0; s < laps_.size(); ++s) {
    const StageTimes& stage = clock.stages()[s];
    const double lap = std::accumulate(stage.seconds.begin(), stage.seconds.end(), 0.0);
    laps_[s].name = stage.name;
    keep(laps_[s].seconds, lap);
    step += lap;
  }
  keep(steps_, step);
  keep(arrivals_, arrival);
}

StepTimes LastSecond::times() const {
  StepTimes times;
  if (steps_.empty()) return times;
  for (const StageTimes& stage : laps_)
    times.stages.push_back({stage.name, summarise(stage.seconds).median});
  times.median = summarise(steps_).median;
  times.worst = *std::ranges::max_element(steps_);
  const double elapsed = arrivals_.back() - arrivals_.front();
  if (elapsed > 0) times.realTimeFactor = double(arrivals_.size() - 1) / frameRate_ / elapsed;
  return times;
}

}  // namespace resect
