// Runs: the ranges of consecutive points of the strips or faces of a shape without indices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class SoMFInt32;

namespace resect {

struct PointRun {
  std::int32_t first, count;
};

// Run i has numVertices[i] points, or all remaining ones if that is -1. The first run begins at
// point startIndex, each later one where the run before it ends. `available`: number of points.
// Throws an Error, beginning with `where`, if a run is not within [0, available).
std::vector<PointRun> pointRuns(const SoMFInt32& numVertices, std::int32_t startIndex,
                                std::size_t available, const std::string& where);

}  // namespace resect
