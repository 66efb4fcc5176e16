// Runs of points. Each strip or face of a shape without indices uses a run, which is a range of
// consecutive points.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class SoMFInt32;

namespace resect {

struct PointRun {
  std::int32_t first, count;  // index of the first point; number of points
};

// Run i has numVertices[i] points. If numVertices[i] is -1, the run has all points that remain. The
// first run begins at the point with the index startIndex. Every other run begins where the
// previous run ends. available: number of points that exist. If a run contains a point that does
// not exist, throws an Error that begins with `where`.
std::vector<PointRun> pointRuns(const SoMFInt32& numVertices, std::int32_t startIndex,
                                std::size_t available, const std::string& where);

}  // namespace resect
