// Reads and writes files of vessels (.vessels): an organ's trees of vessels as text.
//
// The first line is "resect vessels 1". Then each kind has a line with its word and the number of
// its segments, followed by a line per segment. That line has these numbers: the parent's number
// within the kind, or -1 if the segment begins at the root; only after -1, the three coordinates of
// its start; the three coordinates of its end; its radius; 1 if the segment ends among the
// sinusoids, otherwise 0. Lengths are in mm.
#pragma once

#include <filesystem>
#include <string>

#include "anatomy/anatomy.h"

namespace resect {

// Throws Error with file and line if the file does not have this form.
Anatomy readVessels(const std::filesystem::path& path);
// The same from the file's bytes; `name` stands for the file in Errors.
Anatomy parseVessels(std::string text, const std::string& name);
// Coordinates are rounded to 1 um, radii to 0.1 um.
void writeVessels(const std::filesystem::path& path, const Anatomy& anatomy);
std::string formatVessels(const Anatomy& anatomy);

}  // namespace resect
