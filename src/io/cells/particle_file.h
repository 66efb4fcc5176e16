// Which files hold particles, and how is one read or written? The thesis's text (*.dis) or cells
// with all that is known of them (*.resect-cells), told by the name.
#pragma once

#include "io/cells/cells_file.h"
#include "io/cells/discretization_file.h"

namespace resect {

inline bool isParticleFile(const std::filesystem::path& path) {
  return isDiscretizationFile(path) || isCellsFile(path);
}

// unit: metres per unit of a *.dis file; other files are in metres, and 1 is asked for. Throws
// Error as the reader of the format does.
KeptCells readParticleFile(const std::filesystem::path& path, double unit = 1);

// *.resect-cells in full; any other name in the thesis's format, which has no labels, landmarks and
// origin.
void writeParticleFile(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
