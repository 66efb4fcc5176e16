// Measures how long the stages of a time step take. Each stage has a list of durations, which can
// be summarised.
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
// step, and lap(NAME) at the end of each stage. So a stage lasts from the previous call of start()
// or lap() to the call of lap() with the stage's name.
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
