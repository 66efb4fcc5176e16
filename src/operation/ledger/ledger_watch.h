// Decides when an operation's ledger is computed again. A new ledger is due when tissue was
// removed, cut or torn, or when the iso level was changed. But there is at most one ledger per
// kPeriod of simulated time.
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

  // Computes the ledger now. To be called at the start, and after the simulation was restored to
  // another state.
  const Ledger& anew(const Simulation& simulation);
  // To be called after each step. Returns the new ledger if one was due, otherwise null.
  const Ledger* after(const StepReport& report, const Simulation& simulation);
  // For the end of the operation: returns a new ledger if anything has changed since the last
  // ledger was computed, otherwise null.
  const Ledger* last(const Simulation& simulation) {
    return changed_ ? &anew(simulation) : nullptr;
  }
  // The last ledger that was computed.
  const Ledger& ledger() const { return ledger_; }

 private:
  LedgerBooks books_;
  Ledger ledger_;
  std::vector<float> iso_;  // iso level of each organ in ledger_; wound areas depend on this level
  double time_ = 0;         // simulated time of ledger_, s
  bool changed_ = true;     // tissue or iso level has changed since ledger_ was computed
};

}  // namespace resect
