// Reads a region of an organ from a table. docs/scenarios.md, "Regions", lists the keys, which are
// the same in all tables that give a region.
#pragma once

#include "io/scenario/toml_table.h"
#include "sph/region.h"

namespace resect {

// Reads key = [[x, y, z], [x, y, z]], any two opposite corners of a box. `advice`: what to give;
// the Error says it if the key is missing or wrong.
Aabb readBox(const TomlTable& t, const std::string& key, const std::string& advice);

// Reads the keys of a region; the caller reports unknown keys. Throws Error if neither shape nor
// depth is given, or several shapes are.
Region readRegion(const TomlTable& t);

// Reads the landmarks of the table [landmark] in `t`: name = [x, y, z] for each, in fractions of
// the organ's box.
std::vector<Landmark> readLandmarks(const TomlTable& t);

}  // namespace resect
