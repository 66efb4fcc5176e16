// Files *.dis: an organ's discretisation as text, in the format of the original thesis (2004,
// section 4.2.1):
//
//     Discretization:
//     number of particles: 121
//     number of particles inside the object: 121
//     boundingbox dimensions: 10 10 10
//     boundingbox: xmin ymin zmin xmax ymax zmax
//     particle: x: y: z: LevelSet:
//     0 -264.374 223.281 39.7075 100
//     ...
//
// Along each axis sample i lies at min + i * spacing. Two spacings are tried: (max - min) / dims
// for each axis; and, as in the thesis's own files, the longest side of the box / the dims of that
// axis, the same for all three axes. The one that fits all rows better is taken
// (docs/decisions/0002-thesis-grid-is-cubic.md). Positions in rows may be rounded by up to 1/50 of
// a cell; the exact positions of the lattice are used instead.
//
// LevelSet is the colour value, 0 to 100. Particles are the rows with LevelSet > 0 if there are as
// many of these as line 3 declares to be inside. Otherwise particles are the first rows, as many as
// declared, and further rows with LevelSet > 0 are skin cells. Rows with LevelSet 0 are outside.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sph/discretization.h"

namespace resect {

// Whether the file has the extension .dis.
inline bool isDiscretizationFile(const std::filesystem::path& path) {
  return path.extension() == ".dis";
}

// unit > 0: metres per unit of the file's coordinates, which have no unit themselves. Throws Error
// with file and line for anything that is not exactly such a file: a wrong count or order, a short
// or long row, invalid or non-finite numbers, values outside [0, 100], a cell listed twice,
// positions off the grid, anything after the last row.
Discretization readDiscretization(const std::filesystem::path& path, double unit = 1);

// The same from text in memory; `name` stands for the file in errors.
Discretization parseDiscretization(std::string_view text, const std::string& name, double unit = 1);

// The text of such a file, in metres; each number has the fewest digits that restore it exactly.
// Particles come first, then skin cells, both in lattice order; a particle of value 0 holds no
// tissue and is left out. Reading the text gives back the same bits if the lattice is settled
// (sph/lattice_extent.h), as the lattices of organ/discretize.h are; else the spacing may differ in
// its last bits.
std::string formatDiscretization(const Discretization& discretization);

// Written atomically. Throws Error if writing fails.
void writeDiscretization(const std::filesystem::path& path, const Discretization& discretization);

}  // namespace resect
