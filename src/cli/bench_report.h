// Reports of a benchmark as JSON and as a table.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "operation/bench.h"

namespace resect {

// `limit`: none if the largest organ in real time was not searched for.
nlohmann::ordered_json toJson(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                              const Scenario& scenario);
std::string toText(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                   const Scenario& scenario);

}  // namespace resect
