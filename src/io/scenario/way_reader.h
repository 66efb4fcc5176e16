// Reads the way of a tool, that is, its motion in an organ's own coordinates. A way consists of
// keys: the poses at given times of a [[tool]] with frame = "organ".
#pragma once

#include <vector>

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

inline constexpr std::size_t kMostKeys = 1'000'000;  // most keys of a tool
// Most keys of a way. It is lower than kMostKeys, since the position of a way's key takes longer to
// compute.
inline constexpr std::size_t kMostWayKeys = 10'000;

// t: the table of the tool. Throws Error if the table has no keys, or if it names an organ that is
// not in `organs`.
OrganWay readWay(const TomlTable& t, const std::vector<ScenarioOrgan>& organs);

}  // namespace resect
