#include "base/stage_clock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace resect {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

TimeSummary summarise(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[std::size_t(std::lround(share * double(values.size() - 1)))];
  };
  return {at(0.5), at(0.95), values.back(), std::accumulate(values.begin(), values.end(), 0.0)};
}

void StageClock::lap(const char* stage) {
  const auto now = Clock::now();
  auto it = std::find_if(stages_.begin(), stages_.end(),
                         [&](const StageTimes& times) { return times.name == stage; });
  if (it == stages_.end()) {
    stages_.push_back({stage, {}});
    stages_.back().seconds.reserve(4096);
    it = stages_.end() - 1;
  }
  it->seconds.push_back(std::chrono::duration<double>(now - last_).count());
  last_ = Clock::now();
}

}  // namespace resect
