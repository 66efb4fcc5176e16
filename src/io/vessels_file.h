// Files of vessels (.vessels): an organ's trees as text.
//
// The first line is "resect vessels 1". Then each kind has a line with its word and the number of
// its segments, and a line per segment: the number of its parent within the kind (-1: it begins at
// the root), for these the three coordinates of its start, the three of its end, its radius, all in
// mm, and 1 if it ends among the sinusoids, else 0.
#pragma once

#include <filesystem>
#include <string>

#include "anatomy/anatomy.h"

namespace resect {

// Throws Error with file and line if the file is not as above.
Anatomy readVessels(const std::filesystem::path& path);
// The same from the file's bytes; `name` stands for the file in Errors.
Anatomy parseVessels(std::string text, const std::string& name);
// Coordinates are rounded to a micrometre, radii to a tenth of one.
void writeVessels(const std::filesystem::path& path, const Anatomy& anatomy);
std::string formatVessels(const Anatomy& anatomy);

}  // namespace resect
