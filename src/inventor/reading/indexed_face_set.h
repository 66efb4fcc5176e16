// Converts IndexedFaceSet nodes to triangles.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedFaceSet;

namespace resect {

// Appends the triangles of the node's faces to `triangles`. A face ends at a negative index, or at
// the end of coordIndex. A face with fewer than three corners gives no triangle. A face with more
// than three corners is triangulated (geometry/polygon.h). The order of the corners is kept, and
// the vertex ordering in a ShapeHints node is ignored. points: the coordinates that are in effect
// at the node; the triangles contain indices of these points. If an index is beyond the end of
// `points`, throws an Error that begins with `where`.
void appendTriangles(const SoIndexedFaceSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

// The same for a node of another type whose faces end at negative indices. coordIndex: values of
// the node's field coordIndex.
void appendFaces(std::span<const std::int32_t> coordIndex, std::span<const Vec3> points,
                 const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
