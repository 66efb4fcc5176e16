// The ledger of an operation for people and for programs: where all tissue is.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/ledger/ledger.h"

namespace resect {

// One object per organ. Volumes are of the tissue in cells, ml; masses in g, areas in cm^2, margins
// in mm. A margin is null as long as nothing was cut or removed.
nlohmann::ordered_json toJson(const Ledger& ledger);

// Rows of a summary. Each begins with two spaces and a name of ten characters, and ends with a line
// feed. Except for rounding, organ = remains + pieces + debris + removed.
std::string toText(const Ledger& ledger);

}  // namespace resect
