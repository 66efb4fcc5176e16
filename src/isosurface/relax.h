// Smoothing and refinement of a mesh that approximates the zero surface of a function. The region
// where the function is negative is called the body.
//
// A mesh that is closed, oriented and manifold stays so. The results have the same bits at any
// number of threads. `value` is the function. Several threads call it at once. evenOut() calls it
// at most 6 times per point, splitCuttingEdges() at most 18 times per edge.
#pragma once

#include <functional>

#include "geometry/triangle_mesh.h"

namespace resect {

// Approximate signed distance of a position from the surface, m; negative inside.
using ScalarFunction = std::function<double(const Vec3&)>;

// Moves each point within its tangent plane, halfway to the mean of its neighbours, and then
// towards the surface by a Newton step. edge: typical length of the mesh's edges, m. A point is not
// moved if its new position would be more than half of `edge` from the old one, or more than 2 % of
// `edge` from the surface.
void evenOut(const ScalarFunction& value, TriangleMesh& mesh, double edge);

// Splits each edge that cuts off a corner of the body. To find out whether an edge does so, the
// surface is searched from the midpoint of the edge, along the mean of the normals at its two ends.
// If the surface is farther from the midpoint than `tolerance` times the length of the edge, the
// edge is split, and the new point is put on the surface. Returns the number of edges split.
int splitCuttingEdges(const ScalarFunction& value, TriangleMesh& mesh, double tolerance = 0.12);

}  // namespace resect
