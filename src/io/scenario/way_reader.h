// Reads the way of a tool, that is, its motion in an organ's own coordinates: the keys of a
// [[tool]] with frame = "organ".
#pragma once

#include <vector>

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

inline constexpr std::size_t kMostKeys = 1'000'000;  // most keys of a tool
// Most keys of a way. This limit is lower, since it takes longer to compute the position of such a
// key.
inline constexpr std::size_t kMostWayKeys = 10'000;

// t: the table of the tool. Throws Error if the table has no keys, or if it names an organ that is
// not in `organs`.
OrganWay readWay(const TomlTable& t, const std::vector<ScenarioOrgan>& organs);

}  // namespace resect
