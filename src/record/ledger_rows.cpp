#include "record/ledger_rows.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace resect {

bool ledgerIsDue(std::int64_t frame, double frameRate) {
  return frame % std::max<std::int64_t>(1, std::llround(frameRate)) == 0;
}

std::int64_t piecesIn(const RecordedLedger& ledger) {
  std::set<std::pair<std::int64_t, std::int64_t>> pieces;  // a piece has a row per label
  for (const RecordedLedger::Amount& amount : ledger.amounts)
    if (amount.part == "piece") pieces.emplace(amount.organ, amount.number);
  return std::int64_t(pieces.size());
}

std::optional<OperationEvent> pieceEvent(const RecordedLedger& ledger, std::int64_t before) {
  const std::int64_t now = piecesIn(ledger);
  if (now <= before) return std::nullopt;
  return OperationEvent{ledger.branch, ledger.frame,         ledger.time, -1, -1,
                        "piece",       double(now - before), {}};
}

RecordedLedger rowsOf(const Ledger& ledger, std::int64_t branch, const Simulation& simulation) {
  RecordedLedger rows{branch, simulation.frame(), simulation.time(), {}, {}};
  for (std::int64_t o = 0; o < std::int64_t(ledger.organs.size()); ++o) {
    const OrganLedger& organ = ledger.organs[std::size_t(o)];
    const auto add = [&](int label, const char* part, std::int64_t number,
                         const TissueAmount& amount) {
      if (amount.volume > 0)
        rows.amounts.push_back(
            {o, label, part, number, amount.particles, 1e6 * amount.volume, 1e3 * amount.mass});
    };
    for (const LabelLedger& label : organ.labels) {
      add(label.label, "before", 0, label.tissue.before);
      add(label.label, "debris", 0, label.tissue.debris);
      add(label.label, "removed", 0, label.tissue.removed);
      if (label.margin && !std::isinf(*label.margin))
        rows.wounds.push_back({o, label.label, "margin", 1e3 * *label.margin});
    }
    for (std::size_t p = 0; p < organ.parts.size(); ++p)
      for (const PartLedger::Share& share : organ.parts[p].labels)
        add(share.label, p == 0 ? "body" : "piece", std::int64_t(p), share.tissue);
    if (organ.cut > 0) rows.wounds.push_back({o, -1, "cut", 1e4 * organ.cut});
    if (organ.bared > 0) rows.wounds.push_back({o, -1, "bared", 1e4 * organ.bared});
  }
  return rows;
}

}  // namespace resect
