// A flat profile of an operation in the form of gprof: the stages sorted by the time that they
// took, with the number of calls. For each stage it also lists the functions of the thesis's
// program that did the same work, and their share of that program's time (appendix A of the thesis,
// 2004).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/bench.h"

namespace resect {

// The thesis measured two organs, of 120 and of 950 particles. Its figures are shown if the number
// of particles is within 5 % of one of these. Otherwise only the names of the functions in the
// thesis's program are shown.
nlohmann::ordered_json profileJson(const BenchReport& report);
std::string profileText(const BenchReport& report);

}  // namespace resect
