// How are the speed of an operation and the largest organ in real time told: to a program (JSON),
// to a person (a small table)?
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "operation/bench.h"

namespace resect {

// `limit`: none when it was not looked for.
nlohmann::ordered_json toJson(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                              const Scenario& scenario);
std::string toText(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                   const Scenario& scenario);

}  // namespace resect
