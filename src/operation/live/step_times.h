// Speed of an operation, measured over its steps of the last second.
#pragma once

#include <string>
#include <vector>

#include "base/stage_clock.h"

namespace resect {

struct StageTime {
  std::string name;
  double median = 0;  // s
};

struct StepTimes {
  std::vector<StageTime> stages;
  double median = 0, worst = 0;  // s, of whole steps
  double realTimeFactor = 1;     // simulated time / elapsed time
};

class LastSecond {
 public:
  explicit LastSecond(double frameRate);  // simulated frames per second
  // clock: the laps of one step. arrival: when the step ended, steady clock, s.
  void add(const StageClock& clock, double arrival);
  // Measured over the last steps, as many as a second should have. Cost: a sort for each stage.
  StepTimes times() const;

 private:
  void keep(std::vector<double>& values, double value) const;

  double frameRate_;
  std::vector<StageTimes> laps_;
  std::vector<double> steps_, arrivals_;
};

}  // namespace resect
