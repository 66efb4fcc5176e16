// Which consecutive points does each strip or face of a shape without indices use?
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class SoMFInt32;

namespace resect {

struct PointRun {
  std::int32_t first, count;
};

// Run i has numVertices[i] points, or all that are left for -1; the first begins at startIndex.
// Throws an Error, beginning with `where`, when a run leaves [0, available).
std::vector<PointRun> pointRuns(const SoMFInt32& numVertices, std::int32_t startIndex,
                                std::size_t available, const std::string& where);

}  // namespace resect
