// Reads and writes files of vessels (.vessels): an organ's trees of vessels as text.
//
// The first line is "resect vessels 1". The other lines are grouped by kinds of vessels. Each kind
// that has segments begins with a line that gives its word (wordOf(VesselKind), such as
// "portal-vein") and the number of its segments. One line per segment follows. This line has these
// numbers:
// - the number of the parent segment, counted from 0 within the kind, or -1 if the segment is the
//   root of a tree;
// - only for a root: the three coordinates of its start (any other segment starts at the end of its
//   parent);
// - the three coordinates of its end;
// - its radius;
// - 1 if the segment ends among the sinusoids (the capillaries of the liver), otherwise 0.
// Lengths are in mm.
#pragma once

#include <filesystem>
#include <string>

#include "anatomy/anatomy.h"

namespace resect {

// Throws Error with file and line if the file does not have this form.
Anatomy readVessels(const std::filesystem::path& path);
// Does the same with the bytes of a file. Errors use `name` as the file's name.
Anatomy parseVessels(std::string text, const std::string& name);
// Coordinates are rounded to 1 um, radii to 0.1 um.
void writeVessels(const std::filesystem::path& path, const Anatomy& anatomy);
std::string formatVessels(const Anatomy& anatomy);

}  // namespace resect
