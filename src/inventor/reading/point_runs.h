// Runs of points: in a shape without indices, each strip or face uses a range of consecutive
// points.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class SoMFInt32;

namespace resect {

struct PointRun {
  std::int32_t first, count;
};

// Run i has numVertices[i] points; if numVertices[i] is -1, it has all points that remain. The
// first run begins at point startIndex. Each later run begins where the run before it ends.
// `available`: number of points that exist. If a run is not within [0, available), throws an Error
// whose sentence begins with `where`.
std::vector<PointRun> pointRuns(const SoMFInt32& numVertices, std::int32_t startIndex,
                                std::size_t available, const std::string& where);

}  // namespace resect
