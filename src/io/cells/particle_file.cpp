#include "io/cells/particle_file.h"

#include "base/error.h"

namespace resect {

KeptCells readParticleFile(const std::filesystem::path& path, double unit) {
  if (!isCellsFile(path)) return {readDiscretization(path, unit), {}};
  if (unit != 1)
    throw usageError("{} is in metres, whatever its source was in; leave the unit out",
                     path.string());
  return readCells(path);
}

void writeParticleFile(const std::filesystem::path& path, const KeptCells& kept) {
  if (isCellsFile(path))
    writeCells(path, kept);
  else
    writeDiscretization(path, kept.cells);
}

}  // namespace resect
