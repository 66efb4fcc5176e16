// Follows the vessels of an operation: which were cut, when each was closed, where clips were
// placed.
#pragma once

#include <vector>

#include "simulation/simulation.h"
#include "skills/attempt/attempt.h"

namespace resect {

class VesselWatch {
 public:
  // To be called before the first step: takes the vessels that are cut already.
  void begin(const Simulation& simulation, Attempt& attempt) const;
  // To be called after each step.
  void add(const Simulation& simulation, const StepReport& report, Attempt& attempt);
  // Brings the amounts that each vessel has bled up to date.
  void finish(const Simulation& simulation, Attempt& attempt) const;

 private:
  void addClips(const Simulation& simulation, Attempt& attempt);
  void addCuts(const Simulation& simulation, const StepReport& report, Attempt& attempt);

  std::vector<std::size_t> clips_;  // by organ: how many there were
  bool occluded_ = false;
};

// Whether blood is kept from an end of a cut vessel: the end is sealed, or a clip sits on its
// segment or, at most `reach`, m, away, on one that feeds it (its end towards the root) or that it
// feeds.
bool isClosed(const Organ& organ, const VesselInjury& injury, VesselEnd end, double reach = 0.03);

}  // namespace resect
