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
// Sample i of an axis lies at min + i * spacing. Spacing: (max - min) / dims per axis, or, as in
// the thesis's own files, the longest side / its dims on all three axes; whichever fits all rows
// better is taken (docs/decisions/0002-thesis-grid-is-cubic.md). Positions may be rounded to 1/50
// of a cell; the lattice's own are used.
//
// Which rows are inside: those with LevelSet > 0 if they are as many as declared; else the first
// ones up to the declared count, and the others with LevelSet > 0 are skin cells. Rows with
// LevelSet 0 are outside.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sph/discretization.h"

namespace resect {

// By its name: *.dis.
inline bool isDiscretizationFile(const std::filesystem::path& path) {
  return path.extension() == ".dis";
}

// unit > 0: metres per unit of the file's coordinates, which have no unit themselves. Anything that
// is not exactly such a file is an Error that names file and line: a wrong count or order, a short
// or long row, invalid or non-finite numbers, values outside [0, 100], a cell listed twice,
// positions off the grid, anything after the last row.
Discretization readDiscretization(const std::filesystem::path& path, double unit = 1);

// The same from text in memory; `name` stands for the file in errors.
Discretization parseDiscretization(std::string_view text, const std::string& name, double unit = 1);

// Metres; numbers have the fewest digits that restore them exactly. Particles first, then the other
// cells with a value, each in lattice order; a particle of value 0 holds no tissue and is left out.
// Reading it back gives the same bits if the lattice is settled (sph/lattice_extent.h; those of
// organ/discretize.h are), else the spacing may differ in its last bits.
std::string formatDiscretization(const Discretization& discretization);

// Written atomically. Throws Error if writing fails.
void writeDiscretization(const std::filesystem::path& path, const Discretization& discretization);

}  // namespace resect
