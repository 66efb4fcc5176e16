// Follows an operation frame by frame and collects the data by which an attempt is scored. The
// operation may be a recording that is played, or one in progress.
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
  // simulation: in its state before the operation. attempt: must outlive this object; if there is a
  // task, attempt.task must be set already. Throws Error if the organ lacks what the task names.
  AttemptReader(Attempt& attempt, const Scenario& scenario, const Simulation& simulation);

  // To be called after each step. Cost: a few microseconds; once per simulated second also the cost
  // of a ledger. A ledger is an account of all tissue (operation/ledger/ledger.h).
  void add(const Simulation& simulation, const StepReport& report);
  // Updates the amounts of tissue, which add() updates only once per simulated second, and the
  // amounts that each vessel has bled.
  void finish(const Simulation& simulation);
  // Finds the places where the cuts came near the goal's structure (Attempt::margins). Cost: up to
  // a second.
  void measureMargins(const Simulation& simulation);
  // To be called when the work is over: forgets all but the first `frames` frames. No instrument
  // may have been in hand in the forgotten frames. simulation: in its present state.
  void endAt(std::size_t frames, const Simulation& simulation);
  // To be called when work is taken back: forgets all but the first `frames` frames. The number of
  // torn bonds and the time of occluded inflow are not changed: they still include the work that
  // was taken back.
  void rewind(std::size_t frames);

  // Null without a task.
  const GoalWatch* goal() const { return goal_ ? &*goal_ : nullptr; }

 private:
  void keep(std::size_t frames);
  ToolMoment momentOf(const Simulation& simulation, const StepReport& report, std::size_t t) const;
  void takeLedger(const Simulation& simulation);
  void addSpecimens(const OrganLedger& organ, std::size_t number);
  void addHurt(const OrganLedger& organ, std::size_t number);

  Attempt& attempt_;
  std::vector<Pose> rests_;  // rest poses of the instruments
  LedgerBooks books_;
  std::int64_t second_;  // number of frames in a second
  VesselWatch vessels_;
  std::optional<GoalWatch> goal_;
  std::size_t targetOrgan_ = 0;  // index of the goal's organ
  int targetLabel_ = 0;
};

}  // namespace resect
