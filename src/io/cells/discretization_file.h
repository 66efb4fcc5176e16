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
// Each row describes a cell of a lattice. Cell i along an axis has the position min + i * spacing
// on this axis. The file does not give the spacing. In the following, dims are the three numbers of
// the line "boundingbox dimensions". The reader tries two possibilities:
// - Each axis has a spacing of its own: (max - min) / dims of this axis.
// - All three axes have the same spacing: the longest side of the box, divided by the dims of the
//   axis along which this side lies. The thesis's own files are of this kind.
// The reader takes the possibility that fits the positions in all rows better
// (docs/decisions/0002-thesis-grid-is-cubic.md).
//
// The positions in the file may have been rounded, by up to 1/50 of a cell. The reader replaces
// them by the exact positions on the lattice.
//
// LevelSet is the colour value: the percentage of the cell that is tissue, 0 to 100. Line 3 gives
// N, the number of particles inside the object. If exactly N rows have LevelSet > 0, these rows are
// the particles. Otherwise the first N rows are the particles, and the later rows with LevelSet > 0
// are skin cells: cells that hold tissue although their centres are outside the object. A row with
// LevelSet 0 is a cell without tissue.
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

// unit: metres per unit of the file's coordinates, above 0. The file itself does not name its unit.
// Throws an Error that names file and line for:
// - a wrong number of rows or a wrong order;
// - a row with too few or too many numbers;
// - a number that is invalid or not finite, or a value outside [0, 100];
// - a position that is not on the lattice, or a cell that is listed twice;
// - anything after the last row.
Discretization readDiscretization(const std::filesystem::path& path, double unit = 1);

// Does the same with text in memory. Errors use `name` as the file's name.
Discretization parseDiscretization(std::string_view text, const std::string& name, double unit = 1);

// The text of a .dis file, in metres. Each number has the fewest digits that restore it exactly.
// Particles come first, then skin cells, both in the order of their indices in the lattice. A
// particle with the value 0 holds no tissue and is left out. Reading the text gives the same values
// bit for bit. It also gives the same lattice bit for bit if settled() (sph/lattice_extent.h)
// leaves the lattice unchanged, as it does for lattices from organ/discretize.h. For other
// lattices, the spacing that is read may differ in its last bits.
std::string formatDiscretization(const Discretization& discretization);

// Writes the file atomically (io/output/atomic_file.h). Throws Error if writing fails.
void writeDiscretization(const std::filesystem::path& path, const Discretization& discretization);

}  // namespace resect
