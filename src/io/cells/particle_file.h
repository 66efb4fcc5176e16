// Files that hold particles, in one of two formats, chosen by the extension: the thesis's text
// (*.dis) or cells with all their data (*.resect-cells).
#pragma once

#include "io/cells/cells_file.h"
#include "io/cells/discretization_file.h"

namespace resect {

inline bool isParticleFile(const std::filesystem::path& path) {
  return isDiscretizationFile(path) || isCellsFile(path);
}

// unit: metres per unit of a *.dis file; must be 1 for other files, which are in metres. Throws the
// Errors of the format's own reader.
KeptCells readParticleFile(const std::filesystem::path& path, double unit = 1);

// A *.resect-cells file gets everything; a file of any other name is written in the thesis's
// format, which has no labels, landmarks or origin.
void writeParticleFile(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
