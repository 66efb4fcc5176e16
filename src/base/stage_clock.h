// Measures how long the stages of a step take. The result is a list of durations per stage. Such a
// list can be summarised.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace resect {

// Time of the steady clock, s. Only the difference of two times has a meaning.
double steadySeconds();

struct StageTimes {
  std::string name;
  std::vector<double> seconds;  // duration of the stage in each step, s
};

// Median, 95th percentile, maximum and sum of a list of durations, s; all zero for an empty list.
struct TimeSummary {
  double median = 0, p95 = 0, max = 0, total = 0;
};
TimeSummary summarise(std::vector<double> values);

// Measures the stages of many steps, one step after the other. Call start() at the beginning of a
// step, and lap(NAME) at the end of each stage. A stage begins at the previous call of start() or
// lap(). It ends at its own call of lap().
class StageClock {
 public:
  void start() { last_ = Clock::now(); }
  void lap(const char* stage);
  const std::vector<StageTimes>& stages() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  std::vector<StageTimes> stages_;
};

}  // namespace resect
