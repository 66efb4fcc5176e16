// Smoothing and refinement of a mesh of a function's zero surface.
//
// Both functions preserve closed, oriented and manifold, cost some evaluations a point or edge, and
// give the same bits at any number of threads. `value` is called from several threads at once.
#pragma once

#include <functional>

#include "geometry/triangle_mesh.h"

namespace resect {

using ScalarFunction = std::function<double(const Vec3&)>;  // negative inside, m

// Moves every point halfway to the mean of its neighbours within its tangent plane, then onto the
// surface by a Newton step; a point that would move farther than half of `edge` (m), or miss the
// surface, stays.
void evenOut(const ScalarFunction& value, TriangleMesh& mesh, double edge);

// Splits each edge that cuts off a corner of the body: if the surface, searched from the edge's
// midpoint along the mean normal, is farther away than `tolerance` of the edge's length, the edge
// is split at that surface point. Returns the number of edges split.
int splitCuttingEdges(const ScalarFunction& value, TriangleMesh& mesh, double tolerance = 0.12);

}  // namespace resect
