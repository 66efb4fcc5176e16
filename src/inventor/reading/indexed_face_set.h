// Triangles of IndexedFaceSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedFaceSet;

namespace resect {

// Appends the triangles of a node's faces to `triangles`, as indices into `points`. points: the
// coordinates in effect at the node. A face ends at a negative index or at the end of coordIndex.
// Faces with fewer than three corners give no triangle; faces with more than three are triangulated
// (geometry/polygon.h). The order of corners is kept, whatever a ShapeHints node says. If an index
// is beyond the end of `points`, throws an Error that begins with `where`.
void appendTriangles(const SoIndexedFaceSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

// The same for a node of any other type whose faces end at negative indices. coordIndex: its field
// of that name.
void appendFaces(std::span<const std::int32_t> coordIndex, std::span<const Vec3> points,
                 const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
