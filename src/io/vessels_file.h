// Reads and writes files of vessels (.vessels): an organ's trees of vessels as text.
//
// The first line is "resect vessels 1". Then each kind of vessel that has segments has a line
// with the kind's word (wordOf(VesselKind), such as "portal-vein") and the number of its segments,
// followed by one line per segment. The line of a segment has these numbers: the parent's number,
// counted from 0 within the kind, or -1 if the segment is the root of a tree; if it is -1, the
// three coordinates of the segment's start (other segments start at their parent's end); the three
// coordinates of its end; its radius; 1 if the segment ends among the sinusoids, otherwise 0.
// Lengths are in mm.
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
