// Follows an operation frame by frame and keeps what an attempt is scored by: of a recording that
// is played, or of an operation while somebody works on it.
#pragma once

#include <optional>

#include "operation/ledger/ledger.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"
#include "skills/attempt/attempt.h"
#include "skills/attempt/goal_watch.h"
#include "skills/attempt/vessel_watch.h"

namespace resect {

class AttemptReader {
 public:
  // simulation: before the operation. attempt: its task must be set, if it has one; it must outlive
  // this object. Throws Error if the organ lacks what the task names.
  AttemptReader(Attempt& attempt, const Scenario& scenario, const Simulation& simulation);

  // To be called after each step. Cost: that of a ledger once a second, besides some microseconds.
  void add(const Simulation& simulation, const StepReport& report);
  // Brings what is only counted once a second up to date.
  void finish(const Simulation& simulation);
  // Measures where the cuts came near the goal's structure. Cost: up to a second.
  void measureMargins(const Simulation& simulation);
  // Forgets all but the first `frames` frames: work was taken back. Torn bonds and the time of an
  // occluded inflow keep what was taken back.
  void rewind(std::size_t frames);

  // Null without a task.
  const GoalWatch* goal() const { return goal_ ? &*goal_ : nullptr; }

 private:
  ToolMoment momentOf(const Simulation& simulation, const StepReport& report, std::size_t t) const;
  void takeLedger(const Simulation& simulation);
  void addSpecimens(const OrganLedger& organ, std::size_t number);
  void addHurt(const OrganLedger& organ, std::size_t number);

  Attempt& attempt_;
  std::vector<Pose> rests_;  // of the instruments
  LedgerBooks books_;
  std::int64_t second_;  // frames
  VesselWatch vessels_;
  std::optional<GoalWatch> goal_;
  std::size_t targetOrgan_ = 0;  // of the goal
  int targetLabel_ = 0;
};

}  // namespace resect
