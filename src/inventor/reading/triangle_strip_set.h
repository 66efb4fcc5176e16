// Triangles of TriangleStripSet nodes.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

class SoTriangleStripSet;

namespace resect {

// Appends the strips' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). Each run of points (point_runs.h) is a strip. Strips of fewer than three points
// give nothing. Every second triangle of a strip is reversed, so that all have the same
// orientation. Throws an Error, beginning with `where`, if a strip needs more points than exist.
void appendTriangles(const SoTriangleStripSet& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
