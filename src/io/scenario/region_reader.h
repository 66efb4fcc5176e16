// Reads a region of an organ from a TOML table. docs/scenarios.md, "Regions", lists the keys. These
// keys are the same in every table that gives a region.
#pragma once

#include "io/scenario/toml_table.h"
#include "sph/region.h"

namespace resect {

// Reads a box, which the table gives as key = [[x, y, z], [x, y, z]]. The two points are any two
// opposite corners of the box. If the key is missing or does not have two points, throws an Error
// that ends with `advice`, which tells what to give instead.
Aabb readBox(const TomlTable& t, const std::string& key, const std::string& advice);

// Reads the keys of a region; the caller reports unknown keys. Throws Error if a value is wrong, if
// more than one shape is given, or if neither a shape nor a depth is given.
Region readRegion(const TomlTable& t);

// Reads the landmarks of an organ from the table [landmark] inside `t`. Each landmark is a line
// `name = [x, y, z]`. The coordinates are fractions of the organ's box.
std::vector<Landmark> readLandmarks(const TomlTable& t);

}  // namespace resect
