// Triangles of IndexedTriangleStripSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedTriangleStripSet;

namespace resect {

// Appends the strips' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). A strip ends at a negative index or at the end of coordIndex. Strips of fewer than
// three points give nothing. Every second triangle of a strip is reversed, so that all have the
// same orientation. Triangles that use a point twice, by which files join strips, are kept; weld()
// drops them later. Throws an Error, beginning with `where`, if there is no point for an index.
void appendTriangles(const SoIndexedTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
