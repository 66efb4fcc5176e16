// Converts TriangleStripSet nodes to triangles.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

class SoTriangleStripSet;

namespace resect {

// Appends the triangles of the node's strips to `triangles`. Each strip is a run of points
// (inventor/reading/point_runs.h). A strip of fewer than three points gives no triangle. In each
// strip every second triangle is reversed, so that all triangles of the strip have the same
// orientation. points: the coordinates that are in effect at the node; the triangles contain
// indices of these points. If a strip needs more points than exist, throws an Error that begins
// with `where`.
void appendTriangles(const SoTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
