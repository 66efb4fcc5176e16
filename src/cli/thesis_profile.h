// Where does the time of an operation go, beside what appendix A of the original thesis (2004)
// shows of its program? A flat profile as gprof prints it: stages by their time, with calls.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "operation/bench.h"

namespace resect {

// The thesis's figures stand beside organs of its two sizes, 120 and 950 particles, to 5 %; other
// organs' stages have the names of its functions alone.
nlohmann::ordered_json profileJson(const BenchReport& report);
std::string profileText(const BenchReport& report);

}  // namespace resect
