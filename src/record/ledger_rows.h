// Converts a ledger to the rows that a recording keeps. A ledger is an account of all tissue
// (operation/ledger/ledger.h).
#pragma once

#include <optional>

#include "operation/ledger/ledger.h"
#include "record/file/recording_file.h"

namespace resect {

// Whether a recording keeps the ledger after this frame: true once per simulated second. The result
// depends on the frame's number alone. A recorded operation consists of branches
// (operation/live/branch.h). A recording also keeps two other ledgers of each branch: at the
// branch's start, and when operating pauses at the branch's end (Recorder::stood()).
bool ledgerIsDue(std::int64_t frame, double frameRate);

// Number of pieces in a ledger, of all organs together.
std::int64_t piecesIn(const RecordedLedger& ledger);
// If the ledger has more pieces than `before`, returns the event "piece", whose amount is the
// number of new pieces. Otherwise returns nothing.
std::optional<OperationEvent> pieceEvent(const RecordedLedger& ledger, std::int64_t before);

// The rows of `ledger`, which must describe the simulation's present state. Amounts with the volume
// 0 are left out. Infinite margins are left out, too. A margin is the least distance of a structure
// from any cut or bared face, so it is infinite until there is such a face.
RecordedLedger rowsOf(const Ledger& ledger, std::int64_t branch, const Simulation& simulation);

}  // namespace resect
