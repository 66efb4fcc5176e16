#include "operation/ledger/ledger_watch.h"

#include <algorithm>

namespace resect {

const Ledger& LedgerWatch::anew(const Simulation& simulation) {
  ledger_ = books_.ledgerOf(simulation);
  iso_.clear();
  for (const OperatedOrgan& o : simulation.organs()) iso_.push_back(o.organ.iso);
  time_ = simulation.time();
  changed_ = false;
  return ledger_;
}

const Ledger* LedgerWatch::after(const StepReport& report, const Simulation& simulation) {
  const auto incised = [](const std::vector<TissueEdit>& edits) {
    return std::ranges::any_of(
        edits, [](const TissueEdit& edit) { return std::holds_alternative<Incision>(edit.what); });
  };
  changed_ = changed_ || report.removed > 0 || report.removedVolume > 0 || report.severed > 0 ||
             report.torn > 0 || incised(report.edits) || incised(report.caused);
  for (std::size_t i = 0; i < iso_.size(); ++i)
    changed_ = changed_ || iso_[i] != simulation.organs()[i].organ.iso;
  if (!changed_ || simulation.time() - time_ < kPeriod - 1e-9) return nullptr;
  return &anew(simulation);
}

}  // namespace resect
