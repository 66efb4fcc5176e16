// How does a rough mesh of a function's zero surface become an even and exact one?
//
// Both steps keep a closed, oriented, manifold mesh so, cost some evaluations a point or edge, and
// give the same bits at any number of threads. `value` is called from several threads at once.
#pragma once

#include <functional>

#include "geometry/triangle_mesh.h"

namespace resect {

using ScalarFunction = std::function<double(const Vec3&)>;  // negative inside, m

// Every point goes halfway to the mean of its neighbours within its tangent plane, then back to
// zero by a Newton step; one that would go farther than half of `edge` (m), or miss zero, stays.
void evenOut(const ScalarFunction& value, TriangleMesh& mesh, double edge);

// Splits each edge that cuts a corner of the body, as a coarse lattice does at a sharp margin:
// where the surface, sought from the edge's middle along the mean normal, is farther away than
// `tolerance` of the edge's length, a new point is put there. Returns the number of edges split.
int splitCuttingEdges(const ScalarFunction& value, TriangleMesh& mesh, double tolerance = 0.12);

}  // namespace resect
