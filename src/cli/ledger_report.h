// Writes the ledger of an operation as JSON and as text. The ledger says how much of each organ
// remains, was cut off, became debris or was removed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/ledger/ledger.h"

namespace resect {

// One object per organ. A volume is the sum, over cells, of the volume of tissue in each cell
// (operation/ledger/ledger.h). Units: ml for volumes, g for masses, cm^2 for areas, mm for margins.
// A margin is the least distance from a named structure, such as a tumour, to a cut. It is null as
// long as nothing was cut or removed.
nlohmann::ordered_json toJson(const Ledger& ledger);

// Rows of a summary. Each row begins with two spaces and a name of ten characters, and ends with a
// line feed. In the rows, organ = remains + pieces + debris + removed, except for rounding.
std::string toText(const Ledger& ledger);

}  // namespace resect
