// Reads a region of an organ from a table. docs/scenarios.md, "Regions", lists the keys; all tables
// with a region have the same ones.
#pragma once

#include "io/scenario/toml_table.h"
#include "sph/region.h"

namespace resect {

// key = [[x, y, z], [x, y, z]]: any two opposite corners. `advice`: text for the Error.
Aabb readBox(const TomlTable& t, const std::string& key, const std::string& advice);

// Reads the keys of a region; the caller reports unknown keys. Throws Error if no region or several
// are given.
Region readRegion(const TomlTable& t);

// [landmark] with name = [x, y, z] for each, in fractions of the organ's box.
std::vector<Landmark> readLandmarks(const TomlTable& t);

}  // namespace resect
