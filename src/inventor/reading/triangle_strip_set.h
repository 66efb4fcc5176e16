// Which triangles does a TriangleStripSet stand for?
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

class SoTriangleStripSet;

namespace resect {

// Appends the strips' triangles, as indices into `points` (the coordinates that hold at the node),
// to `triangles`. Strip i uses the next numVertices[i] points, the first strip beginning at
// startIndex; -1 means all that are left; strips of fewer than three points give nothing. Every
// second triangle of a strip is turned, so that all look the same way. Throws an Error, beginning
// with `where`, when a strip needs more points than there are.
void appendTriangles(const SoTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
