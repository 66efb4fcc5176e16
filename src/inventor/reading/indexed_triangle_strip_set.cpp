#include "inventor/reading/indexed_triangle_strip_set.h"

#include <Inventor/nodes/SoIndexedTriangleStripSet.h>

#include "base/error.h"

namespace resect {

void appendTriangles(const SoIndexedTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles) {
  const std::int32_t* index = shape.coordIndex.getValues(0);
  const std::int32_t count = shape.coordIndex.getNum();
  std::int32_t first = 0;  // of the strip
  for (std::int32_t i = 0; i < count; ++i) {
    if (index[i] < 0) {
      first = i + 1;
      continue;
    }
    if (std::size_t(index[i]) >= points.size())
      throw error("{} IndexedTriangleStripSet uses point {} of only {}; export the model again",
                  where, index[i], points.size());
    if (i - first < 2) continue;
    const std::int32_t a = index[i - 2], b = index[i - 1], c = index[i];
    triangles.push_back((i - first) % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
  }
}

}  // namespace resect
