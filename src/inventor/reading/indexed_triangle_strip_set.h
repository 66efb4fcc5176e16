// Triangles of IndexedTriangleStripSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedTriangleStripSet;

namespace resect {

// Appends the strips' triangles, as indices into `points` (the coordinates in effect at the node),
// to `triangles`. Strips end at a negative index or at the end of coordIndex; those of fewer than
// three points give nothing. Every second triangle of a strip is reversed; triangles with a
// repeated point, which join strips, are kept (weld drops them). Throws an Error, beginning with
// `where`, when an index has no point.
void appendTriangles(const SoIndexedTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
