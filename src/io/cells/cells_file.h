// How are an organ's cells kept with all that is known of them? In a file *.resect-cells: lattice,
// colour values, particles, labels with their names, landmarks, and where they come from.
//
// docs/cells_file.md describes it byte by byte: a header that people can read, then runs
// (io/cells/byte_runs.h), then a checksum. Lengths are in metres. The same cells give the same
// bytes on every machine; reading gives back the same bits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sph/discretization.h"

namespace resect {

// Where cells come from, for people; no date and no folder, so that the same input gives the same
// bytes.
struct CellsOrigin {
  std::string program;  // that wrote them, with its version; may be empty
  std::string source;   // name of the model file, or "liver"; may be empty
  double unit = 1;      // metres per unit of that file
};

struct KeptCells {
  Discretization cells;
  CellsOrigin origin;
};

// By its name: *.resect-cells.
inline bool isCellsFile(const std::filesystem::path& path) {
  return path.extension() == ".resect-cells";
}

// Throws Error when the cells cannot be kept: no cell or more than kMaxCells, a lattice beyond
// 1000 km, a name that is not UTF-8.
std::string formatCells(const KeptCells& kept);

// Whatever is not exactly such a file is refused by an Error that names it; memory is taken only
// when all lengths fit, and for kMaxCells at most. `name` stands for the file in errors.
KeptCells parseCells(std::string_view bytes, const std::string& name);

KeptCells readCells(const std::filesystem::path& path);
// Written under a temporary name, then renamed. Throws Error when the disk refuses.
void writeCells(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
