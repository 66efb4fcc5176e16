// Reads the way of a tool, that is, its motion in an organ's own coordinates. A way is given by a
// [[tool]] with frame = "organ". It consists of keys. Here a key is not a key of TOML, but the
// tool's pose at one time: an element of the tool's list `keys`.
#pragma once

#include <vector>

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

inline constexpr std::size_t kMostKeys = 1'000'000;  // most keys of a tool
// Most keys of a way. It is lower than kMostKeys, since the position of a way's key takes longer to
// compute.
inline constexpr std::size_t kMostWayKeys = 10'000;

// t: the table of the tool. Throws Error if the list `keys` is missing or empty, or if the table
// names an organ that is not in `organs`.
OrganWay readWay(const TomlTable& t, const std::vector<ScenarioOrgan>& organs);

}  // namespace resect
