// A flat profile of an operation, as gprof prints it, beside the profile in appendix A of the
// original thesis (2004): stages sorted by time, with the number of calls.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "operation/bench.h"

namespace resect {

// The thesis measured organs of 120 and 950 particles: its figures are shown for organs of these
// sizes, within 5 %. For other organs only the names of the functions of its program are shown.
nlohmann::ordered_json profileJson(const BenchReport& report);
std::string profileText(const BenchReport& report);

}  // namespace resect
