// Converts IndexedTriangleStripSet nodes to triangles.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoIndexedTriangleStripSet;

namespace resect {

// Appends the triangles of the node's strips to `triangles`. A strip ends at a negative index, or
// at the end of coordIndex. A strip of fewer than three points gives no triangle. In each strip
// every second triangle is reversed, so that all triangles of the strip have the same orientation.
// Some files join strips by triangles that use a point twice. These triangles are kept here, and
// weld() (geometry/repair/weld.h) drops them later. points: the coordinates that are in effect at
// the node; the triangles contain indices of these points. If an index is beyond the end of
// `points`, throws an Error that begins with `where`.
void appendTriangles(const SoIndexedTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
