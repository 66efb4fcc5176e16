// Converts a ledger to the rows that a recording keeps.
#pragma once

#include <optional>

#include "operation/ledger/ledger.h"
#include "record/file/recording_file.h"

namespace resect {

// Whether a recording keeps the ledger after this frame. It does so once per simulated second; the
// frame's number alone decides. A recording also keeps the ledger at the start of each branch and
// where operating pauses at the end of a branch (Recorder::stood()).
bool ledgerIsDue(std::int64_t frame, double frameRate);

// Number of pieces in a ledger, of all organs together.
std::int64_t piecesIn(const RecordedLedger& ledger);
// The event "piece" if the ledger has more pieces than `before`; else nothing.
std::optional<OperationEvent> pieceEvent(const RecordedLedger& ledger, std::int64_t before);

// The rows of the ledger after the simulation's present frame. Amounts without volume are left out.
// Margins are left out as long as they are infinite, that is, before anything was cut or bared.
RecordedLedger rowsOf(const Ledger& ledger, std::int64_t branch, const Simulation& simulation);

}  // namespace resect
