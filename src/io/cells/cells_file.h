// Reads and writes files *.resect-cells: an organ's cells, that is lattice, colour values,
// particles, labels with names and landmarks, and the origin of the cells.
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

// Where the cells come from, as information for people. There is no date and no folder, so that the
// same input gives the same bytes.
struct CellsOrigin {
  std::string program;  // program that wrote them, with its version; may be empty
  std::string source;   // name of the model file, or "liver"; may be empty
  double unit = 1;      // metres per unit of the model file
};

struct KeptCells {
  Discretization cells;
  CellsOrigin origin;
};

// Whether the file's name ends in .resect-cells.
inline bool isCellsFile(const std::filesystem::path& path) {
  return path.extension() == ".resect-cells";
}

// The bytes of such a file. Throws Error if the cells cannot be stored: there are none or more than
// kMaxCells, the lattice reaches beyond 1000 km, or a name is not UTF-8.
std::string formatCells(const KeptCells& kept);

// Reads the bytes of such a file. Throws Error if anything in them is wrong. Memory is allocated
// only after all lengths are checked, and for kMaxCells at most. `name`: the file's name for
// errors.
KeptCells parseCells(std::string_view bytes, const std::string& name);

KeptCells readCells(const std::filesystem::path& path);
// Writes atomically (io/atomic_file.h). Throws Error if writing fails.
void writeCells(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
