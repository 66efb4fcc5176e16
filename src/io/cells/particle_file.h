// Reads and writes files of particles. The extension chooses one of two formats: the thesis's text
// (*.dis), or cells with all their data (*.resect-cells).
#pragma once

#include "io/cells/cells_file.h"
#include "io/cells/discretization_file.h"

namespace resect {

inline bool isParticleFile(const std::filesystem::path& path) {
  return isDiscretizationFile(path) || isCellsFile(path);
}

// unit: metres per unit of a *.dis file. A *.resect-cells file is always in metres. So for such a
// file `unit` must be 1; otherwise throws Error. Also throws the Errors of readCells() or
// readDiscretization().
KeptCells readParticleFile(const std::filesystem::path& path, double unit = 1);

// Writes all data if the path ends in .resect-cells. A file with any other name is written in the
// thesis's format, which has no labels, no landmarks, no vessels, and no information about the
// origin of the cells.
void writeParticleFile(const std::filesystem::path& path, const KeptCells& kept);

}  // namespace resect
