// How does a settings file name a part of an organ? docs/scenarios.md, "Regions", lists the keys;
// every table that asks for a region takes the same ones.
#pragma once

#include "io/scenario/toml_table.h"
#include "sph/region.h"

namespace resect {

// key = [[x, y, z], [x, y, z]]: any two corners that face each other. `advice`: what to give.
Aabb readBox(const TomlTable& t, const std::string& key, const std::string& advice);

// Asks for the keys of a region; the caller refuses those that are left. Throws Error when none or
// several are named.
Region readRegion(const TomlTable& t);

// [landmark] with name = [x, y, z] for each, in fractions of the organ's box.
std::vector<Landmark> readLandmarks(const TomlTable& t);

}  // namespace resect
