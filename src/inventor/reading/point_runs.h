// Ranges of consecutive points that the strips or faces of a shape without indices use.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class SoMFInt32;

namespace resect {

struct PointRun {
  std::int32_t first, count;
};

// Run i has numVertices[i] points, or all remaining points for -1; the first begins at startIndex.
// Throws an Error, beginning with `where`, if a run is not within [0, available).
std::vector<PointRun> pointRuns(const SoMFInt32& numVertices, std::int32_t startIndex,
                                std::size_t available, const std::string& where);

}  // namespace resect
