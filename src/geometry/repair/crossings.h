// Winding numbers of points by counting crossings of a ray along +X with a closed mesh.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// For each point the signed number of times that a ray along +X leaves the mesh, which must be
// closed and oriented: 1 inside a body, 0 outside, -1 inside one that is inside out. Rays through
// edges and corners count once (edges are half-open, evaluated alike by both neighbours); a point
// on the surface gets the number of one of its sides. Triangles are sorted into slabs along Z, so m
// points cost about m * sqrt(triangles) after O(triangles).
std::vector<int> crossingNumbers(const TriangleMesh& mesh, std::span<const Vec3> points);

}  // namespace resect
