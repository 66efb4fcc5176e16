#include "inventor/reading/face_set.h"

#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoQuadMesh.h>

#include <numeric>

#include "base/error.h"
#include "geometry/polygon.h"
#include "inventor/reading/point_runs.h"

namespace resect {

void appendTriangles(const SoFaceSet& shape, std::span<const Vec3> points, const std::string& where,
                     std::vector<Triangle>& triangles) {
  std::vector<std::int32_t> loop;
  for (const auto& [first, count] : pointRuns(shape.numVertices, shape.startIndex.getValue(),
                                              points.size(), where + " FaceSet")) {
    loop.resize(std::size_t(count));
    std::iota(loop.begin(), loop.end(), first);
    triangulatePolygon(points, loop, triangles);
  }
}

void appendTriangles(const SoQuadMesh& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles) {
  const std::int64_t rows = shape.verticesPerColumn.getValue();
  const std::int64_t columns = shape.verticesPerRow.getValue();
  const std::int64_t first = shape.startIndex.getValue();
  const auto available = std::int64_t(points.size());
  if (rows < 2 || columns < 2) return;
  if (first < 0 || first > available || rows > available || columns > available ||
      rows * columns > available - first)
    throw error(
        "{} QuadMesh has {} x {} points from {} on, but there are only {}; export the model "
        "again",
        where, columns, rows, first, available);
  for (std::int64_t r = 0; r + 1 < rows; ++r)
    for (std::int64_t c = 0; c + 1 < columns; ++c) {
      const auto a = std::int32_t(first + r * columns + c);
      const auto below = std::int32_t(a + columns);
      triangles.push_back({a, below, below + 1});
      triangles.push_back({a, below + 1, a + 1});
    }
}

}  // namespace resect
