// Speed of an operation, measured over the steps of the last second of simulated time.
#pragma once

#include <string>
#include <vector>

#include "base/stage_clock.h"

namespace resect {

struct StageTime {
  std::string name;
  double median = 0;  // median computing time of the stage, s
};

struct StepTimes {
  std::vector<StageTime> stages;
  double median = 0, worst = 0;  // median and longest computing time of whole steps, s
  double realTimeFactor = 1;     // simulated time / elapsed time
};

// Keeps the times of the last n steps; n is `frameRate`, rounded up.
class LastSecond {
 public:
  explicit LastSecond(double frameRate);  // simulated frames per second
  // Adds one step. clock: the times of the stages of this step alone. arrival: steadySeconds() at
  // the end of the step, s.
  void add(const StageClock& clock, double arrival);
  // The times of the steps that are kept. Cost: a sort for each stage.
  StepTimes times() const;

 private:
  void keep(std::vector<double>& values, double value) const;

  double frameRate_;
  std::vector<StageTimes> laps_;
  std::vector<double> steps_, arrivals_;
};

}  // namespace resect
