// Reads the way of a tool in an organ's own coordinates: the keys of a [[tool]] with frame =
// "organ".
#pragma once

#include <vector>

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

inline constexpr std::size_t kMostKeys = 1'000'000;  // of a tool
inline constexpr std::size_t kMostWayKeys = 10'000;  // of its way: each is searched on the organ

// t: the table of the tool. Throws Error if it has no keys, or if they name an organ that is not in
// `organs`.
OrganWay readWay(const TomlTable& t, const std::vector<ScenarioOrgan>& organs);

}  // namespace resect
