// Files that hold particles, chosen by name: the thesis's text (*.dis) or cells with all their data
// (*.resect-cells).
#pragma once

#include "io/cells/cells_file.h"
#include "io/cells/discretization_file.h"

namespace resect {

inline bool isParticleFile(const std::filesystem::path& path) {
  return isDiscretizationFile(path) || isCellsFile(path);
}

// unit: metres per unit of a *.dis file; must be 1 for other files, which are in metres. Throws
// Error as the reader of the format does.
KeptCells readParticleFile(const std::filesystem::path& path, double unit = 1);

// *.resect-cells in full; any other name in the thesis's format, which has no labels, landmarks and
// origin.
void writeParticleFile(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
