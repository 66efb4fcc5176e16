// Follows the vessels of an operation: which vessels were cut, when each of the cut vessels was
// closed, and where clips were placed.
#pragma once

#include <vector>

#include "simulation/simulation.h"
#include "skills/attempt/attempt.h"

namespace resect {

class VesselWatch {
 public:
  // To be called before the first step: records the vessels that have been cut already.
  void begin(const Simulation& simulation, Attempt& attempt) const;
  // To be called after each step.
  void add(const Simulation& simulation, const StepReport& report, Attempt& attempt);
  // Updates the volume of blood that each vessel has lost.
  void finish(const Simulation& simulation, Attempt& attempt) const;

 private:
  void addClips(const Simulation& simulation, Attempt& attempt);
  void addCuts(const Simulation& simulation, const StepReport& report, Attempt& attempt);

  std::vector<std::size_t> clips_;  // per organ: number of clips after the last step
  bool occluded_ = false;
};

}  // namespace resect
