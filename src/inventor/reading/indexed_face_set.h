// Triangles of IndexedFaceSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedFaceSet;

namespace resect {

// Appends the faces' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). A face ends at a negative index or at the end of coordIndex. Faces of fewer than
// three corners give nothing; faces of more than three are triangulated (geometry/polygon.h). The
// order of corners is kept, whatever a ShapeHints node says. Throws an Error, beginning with
// `where`, if there is no point for an index.
void appendTriangles(const SoIndexedFaceSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

// The same for the coordIndex of any node whose faces end at negative indices.
void appendFaces(std::span<const std::int32_t> coordIndex, std::span<const Vec3> points,
                 const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
