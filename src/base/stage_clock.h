// Measures the stages of a step: one list of durations per stage, and their summary.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace resect {

// Time of the steady clock, s; only differences have a meaning.
double steadySeconds();

struct StageTimes {
  std::string name;
  std::vector<double> seconds;  // one per step
};

// Median, 95th percentile, maximum and sum of some durations; all zero when there are none.
struct TimeSummary {
  double median = 0, p95 = 0, max = 0, total = 0;
};
TimeSummary summarise(std::vector<double> values);

// Measures the stages of many steps, one step after the other: start() begins a step,
// lap("findContacts") ends its stage of that name.
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
