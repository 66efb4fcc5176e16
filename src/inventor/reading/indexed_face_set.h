// Triangles of IndexedFaceSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedFaceSet;

namespace resect {

// Appends the faces' triangles, as indices into `points` (the coordinates in effect at the node),
// to `triangles`. Faces end at a negative index or at the end of coordIndex; those of fewer than
// three corners give nothing, those of more are triangulated (geometry/polygon.h). The order of
// corners is kept, whatever ShapeHints says. Throws an Error, beginning with `where`, when an index
// has no point.
void appendTriangles(const SoIndexedFaceSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

// The same for any list of faces that ends each face with a negative number; `where` names it.
void appendFaces(std::span<const std::int32_t> coordIndex, std::span<const Vec3> points,
                 const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
