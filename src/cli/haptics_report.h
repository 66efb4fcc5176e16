// The report of `resect bench --haptics`, as JSON or as a text with a table.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "haptics/bench/haptics_bench.h"

namespace resect {

nlohmann::ordered_json toJson(const HapticsReport& report, const Scenario& scenario);
std::string toText(const HapticsReport& report, const Scenario& scenario);

}  // namespace resect
