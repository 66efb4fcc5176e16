// Follows the vessels of an operation: which were cut, when each was closed, and where clips were
// placed.
#pragma once

#include <vector>

#include "simulation/simulation.h"
#include "skills/attempt/attempt.h"

namespace resect {

class VesselWatch {
 public:
  // To be called before the first step: records the vessels that are cut already.
  void begin(const Simulation& simulation, Attempt& attempt) const;
  // To be called after each step.
  void add(const Simulation& simulation, const StepReport& report, Attempt& attempt);
  // Brings the amounts that each vessel has bled up to date.
  void finish(const Simulation& simulation, Attempt& attempt) const;

 private:
  void addClips(const Simulation& simulation, Attempt& attempt);
  void addCuts(const Simulation& simulation, const StepReport& report, Attempt& attempt);

  std::vector<std::size_t> clips_;  // number of clips after the last step, by organ
  bool occluded_ = false;
};

// Whether an end of a cut vessel cannot bleed: the end is sealed, or a clip closes it. The clip is
// on the cut segment, or on another segment at most `reach`, m, away along the vessels: for the
// root end, on a segment that feeds the cut one; for the far end, on a segment that the cut one
// feeds.
bool isClosed(const Organ& organ, const VesselInjury& injury, VesselEnd end, double reach = 0.03);

}  // namespace resect
