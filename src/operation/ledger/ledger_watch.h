// Decides when an operation's ledger is reckoned again: when tissue was removed, cut or torn, and
// at most once in kPeriod of simulated time.
//
// The same steps from the same state give the same ledgers at the same frames.
#pragma once

#include "operation/ledger/ledger.h"

namespace resect {

class LedgerWatch {
 public:
  static constexpr double kPeriod = 1;  // s, of simulated time

  LedgerWatch(const Scenario& scenario, const Simulation& simulation)
      : books_(scenario, simulation) {}

  // To be called at the start, and when the simulation has been restored to another state.
  const Ledger& anew(const Simulation& simulation);
  // To be called after each step. The new ledger if one is due, else null.
  const Ledger* after(const StepReport& report, const Simulation& simulation);
  // The ledger if something has changed since the last one, else null: for the operation's end.
  const Ledger* last(const Simulation& simulation) {
    return changed_ ? &anew(simulation) : nullptr;
  }
  // The one that was reckoned last.
  const Ledger& ledger() const { return ledger_; }

 private:
  LedgerBooks books_;
  Ledger ledger_;
  std::vector<float> iso_;  // of each organ's surface, which shows the faces of wounds
  double time_ = 0;         // at which ledger_ was reckoned, s
  bool changed_ = true;     // since then
};

}  // namespace resect
