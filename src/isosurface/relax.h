// Smoothing and refinement of a mesh of a function's zero surface.
//
// Both functions keep a mesh closed, oriented and manifold, evaluate `value` a few times per point
// or edge, and give the same bits at any number of threads. `value` is called from several threads
// at once.
#pragma once

#include <functional>

#include "geometry/triangle_mesh.h"

namespace resect {

using ScalarFunction = std::function<double(const Vec3&)>;  // negative inside, m

// Moves every point within its tangent plane, halfway to the mean of its neighbours, and then onto
// the surface by a Newton step. A point stays where it is if it would move farther than half of
// `edge` (m) or miss the surface.
void evenOut(const ScalarFunction& value, TriangleMesh& mesh, double edge);

// Splits each edge that cuts off a corner of the body. From the edge's midpoint the surface is
// searched along the mean normal of its ends; if it is farther away than `tolerance` times the
// edge's length, the edge is split, with its new point on the surface. Returns the number of edges
// split.
int splitCuttingEdges(const ScalarFunction& value, TriangleMesh& mesh, double tolerance = 0.12);

}  // namespace resect
