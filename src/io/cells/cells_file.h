// Files *.resect-cells: an organ's cells with lattice, colour values, particles, labels with names,
// landmarks and origin.
//
// docs/cells_file.md describes the format: a text header, then runs (io/cells/byte_runs.h), then a
// checksum. Lengths are in metres. The same cells give the same bytes on every machine; reading
// gives back the same bits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sph/discretization.h"

namespace resect {

// Origin of the cells, for people. No date and no folder, so that the same input gives the same
// bytes.
struct CellsOrigin {
  std::string program;  // program that wrote them, with its version; may be empty
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

// Throws Error if the cells cannot be stored: no cell or more than kMaxCells, a lattice beyond 1000
// km, a name that is not UTF-8.
std::string formatCells(const KeptCells& kept);

// Anything that is not exactly such a file is an Error that names it; memory is allocated only
// after all lengths are checked, and for kMaxCells at most. `name` stands for the file in errors.
KeptCells parseCells(std::string_view bytes, const std::string& name);

KeptCells readCells(const std::filesystem::path& path);
// Written atomically. Throws Error if writing fails.
void writeCells(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
