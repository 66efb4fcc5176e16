#include "inventor/reading/point_runs.h"

#include <Inventor/fields/SoMFInt32.h>

#include "base/error.h"

namespace resect {

std::vector<PointRun> pointRuns(const SoMFInt32& numVertices, std::int32_t startIndex,
                                std::size_t available, const std::string& where) {
  std::vector<PointRun> runs;
  std::int64_t next = startIndex;
  for (int i = 0; i < numVertices.getNum(); ++i) {
    std::int64_t count = numVertices[i];
    if (count == -1) count = std::int64_t(available) - next;
    if (next < 0 || count < 0 || next + count > std::int64_t(available))
      throw error(
          "{} asks with number {} of numVertices for {} points from point {} on, but there are "
          "only "
          "{} in all; export the model again",
          where, i, count, next, available);
    runs.push_back({std::int32_t(next), std::int32_t(count)});
    next += count;
  }
  return runs;
}

}  // namespace resect
