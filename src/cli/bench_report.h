// The report of a benchmark, as JSON or as a text with a table.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "operation/bench.h"

namespace resect {

// `limit`: the largest organ that is simulated in real time; empty if it was not searched for.
nlohmann::ordered_json toJson(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                              const Scenario& scenario);
std::string toText(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                   const Scenario& scenario);

}  // namespace resect
