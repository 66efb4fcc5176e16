// Reads and writes files *.resect-cells. Such a file holds an organ's lattice of cells, colour
// values (the percentage of tissue in each cell), particles (cells whose centres are inside the
// organ), labels, names of labels, landmarks and vessels. It also gives the names of the files from
// which the cells were made.
//
// docs/cells_file.md describes the format: a text header, then runs (io/cells/byte_runs.h), then a
// checksum. Lengths are in metres. The same cells give the same bytes on every machine. Cells that
// are read from a file equal the written cells bit for bit. Coordinates of vessels are an
// exception: the file rounds them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "sph/discretization.h"

namespace resect {

// A file from which the cells were made.
struct CellsInput {
  std::string file;    // name without folder
  std::string role;    // its content: "organ", "tumour", "portal-vein", ...
  std::string format;  // "NIfTI-1 label image, 147 x 120 x 53 voxels of 1.5 x 1.5 x 3 mm, axes RAS"
  std::string crc32;   // checksum of the file's bytes: eight hexadecimal digits

  bool operator==(const CellsInput&) const = default;
};

// Where the cells come from, as information for people. No date and no folder is stored, so that
// the same input always gives the same bytes.
struct CellsOrigin {
  std::string program;               // program that wrote the cells, with its version; may be empty
  std::string source;                // name of the model file, or "liver"; may be empty
  double unit = 1;                   // metres per unit of the model file
  std::vector<CellsInput> inputs{};  // may be empty
};

struct KeptCells {
  Discretization cells;
  CellsOrigin origin;
  Anatomy vessels{};  // in the coordinates of the cells; rounded to a micrometre in the file
};

// Whether the file's name ends in .resect-cells.
inline bool isCellsFile(const std::filesystem::path& path) {
  return path.extension() == ".resect-cells";
}

// The bytes of a *.resect-cells file. Throws Error if one of these conditions is not met:
// - There are 1 to kMaxCells cells, and fewer than a million along each axis.
// - The coordinates of the lattice's origin are below 1000 km, and so is the spacing.
// - Names are in UTF-8.
// - The header has at most 1 MB.
std::string formatCells(const KeptCells& kept);

// Reads the bytes of a *.resect-cells file. Throws Error if anything in them is wrong. Memory is
// allocated only after all lengths have been checked, and never for more than kMaxCells cells.
// Errors use `name` as the file's name.
KeptCells parseCells(std::string_view bytes, const std::string& name);

KeptCells readCells(const std::filesystem::path& path);
// Writes atomically (io/output/atomic_file.h). Throws Error if writing fails.
void writeCells(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
