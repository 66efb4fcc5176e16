// Triangles of TriangleStripSet nodes.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

class SoTriangleStripSet;

namespace resect {

// Appends the strips' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). Each run of points (point_runs.h) is a strip. A strip of fewer than three points
// gives nothing. In each strip every second triangle is reversed, so that all have the same
// orientation. Throws an Error, which begins with `where`, if a strip needs more points than exist.
void appendTriangles(const SoTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
