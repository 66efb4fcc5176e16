#include "inventor/reading/triangle_strip_set.h"

#include <Inventor/nodes/SoTriangleStripSet.h>

#include "base/error.h"
#include "inventor/reading/point_runs.h"

namespace resect {

void appendTriangles(const SoTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles) {
  const auto runs = pointRuns(shape.numVertices, shape.startIndex.getValue(), points.size(),
                              where + " TriangleStripSet");
  for (const auto& [first, count] : runs)
    for (std::int32_t i = 0; i + 2 < count; ++i) {
      const std::int32_t a = first + i;
      triangles.push_back(i % 2 == 0 ? Triangle{a, a + 1, a + 2} : Triangle{a + 1, a, a + 2});
    }
}

}  // namespace resect
