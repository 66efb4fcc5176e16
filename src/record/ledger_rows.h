// A ledger as a recording keeps it.
#pragma once

#include <optional>

#include "operation/ledger/ledger.h"
#include "record/file/recording_file.h"

namespace resect {

// Whether a recording keeps the ledger after this frame: once a simulated second, whatever
// happened, so that it does not depend on what was recorded before. Besides, it keeps that of the
// start of each branch, and that of the operation's end.
bool ledgerIsDue(std::int64_t frame, double frameRate);

// Pieces in a ledger, of all organs.
std::int64_t piecesIn(const RecordedLedger& ledger);
// The event "piece" of a frame after which there are more pieces than `before`; else none.
std::optional<OperationEvent> pieceEvent(const RecordedLedger& ledger, std::int64_t before);

// The ledger after the simulation's present frame, as rows. Amounts of 0 are left out, but for what
// there was before; so are margins of structures from which nothing was cut or removed.
RecordedLedger rowsOf(const Ledger& ledger, std::int64_t branch, const Simulation& simulation);

}  // namespace resect
