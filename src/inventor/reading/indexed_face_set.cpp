#include "inventor/reading/indexed_face_set.h"

#include <Inventor/nodes/SoIndexedFaceSet.h>

#include "base/error.h"
#include "geometry/polygon.h"

namespace resect {

void appendFaces(std::span<const std::int32_t> coordIndex, std::span<const Vec3> points,
                 const std::string& where, std::vector<Triangle>& triangles) {
  triangles.reserve(triangles.size() + coordIndex.size() / 4);  // exact if all faces are triangles
  std::size_t first = 0;
  for (std::size_t i = 0; i <= coordIndex.size(); ++i) {
    if (i < coordIndex.size() && coordIndex[i] >= 0) {
      if (std::size_t(coordIndex[i]) >= points.size())
        throw error("{} uses point {} of only {}; export the model again", where, coordIndex[i],
                    points.size());
      continue;
    }
    triangulatePolygon(points, coordIndex.subspan(first, i - first), triangles);
    first = i + 1;
  }
}

void appendTriangles(const SoIndexedFaceSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles) {
  appendFaces({shape.coordIndex.getValues(0), std::size_t(shape.coordIndex.getNum())}, points,
              where + " IndexedFaceSet", triangles);
}

}  // namespace resect
