// Triangles of IndexedTriangleStripSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedTriangleStripSet;

namespace resect {

// Appends the strips' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). A strip ends at a negative index or at the end of coordIndex. A strip of fewer than
// three points gives nothing. In each strip every second triangle is reversed, so that all have the
// same orientation. Some files join strips by triangles that use a point twice. Such triangles are
// kept here; weld() drops them later. Throws an Error, which begins with `where`, if an index names
// a point that does not exist.
void appendTriangles(const SoIndexedTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
