// A flat profile of an operation in the form of gprof. It lists the stages of a simulation step
// with their numbers of calls, sorted by the time that each stage took. Resect continues a thesis
// of 2004. For each stage, the profile names the functions of the thesis's program that did the
// same work. It also says which share of the running time of the thesis's program these functions
// took (appendix A of the thesis).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/bench.h"

namespace resect {

// The thesis measured two organs: one of 120 particles and one of 950 particles. The figures of the
// thesis are shown if the operation's number of particles is within 5 % of one of these numbers.
// Otherwise only the names of the functions in the thesis's program are shown.
nlohmann::ordered_json profileJson(const BenchReport& report);
std::string profileText(const BenchReport& report);

}  // namespace resect
