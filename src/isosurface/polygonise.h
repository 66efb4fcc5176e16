// Triangle mesh of the zero surface of a function. The region where the function is negative is
// called the body.
//
// The function is sampled at the points of a body-centred cubic lattice. The lattice divides space
// into tetrahedra that are congruent and nearly regular. Each tetrahedron with corners on both
// sides of the surface gives one or two triangles. So the mesh is closed, oriented and manifold for
// any function. The mesh is then smoothed. If an edge of the mesh cuts off a corner or a sharp
// ridge of the body, the edge is split (isosurface/relax.h). Cost: at most 2 evaluations of the
// function per cube of the lattice, and about 30 per point of the mesh. The results have the same
// bits at any number of threads.
//
// Sources: marching tetrahedra, Doi, Koide (1991); the lattice, Labelle, Shewchuk (2007).
#pragma once

#include <limits>

#include "geometry/triangle_mesh.h"
#include "isosurface/relax.h"

namespace resect {

struct PolygoniseSettings {
  // Length, m, > 0. Few edges of the mesh are longer than `edge`. The mean length of all its edges
  // is about three quarters of `edge`. Parts of the body that are thinner than `edge` may be lost.
  double edge = 0.0025;
  // Largest slope of the function (Lipschitz constant), > 0. A block of cubes is skipped if the
  // value at its centre shows that the surface cannot reach the block. Infinite: nothing is
  // skipped. If the given slope is too small, parts of the surface are lost.
  double lipschitz = std::numeric_limits<double>::infinity();
  // Number of rounds of smoothing and splitting. With 0 rounds, the triangles stay as the lattice
  // gives them, including slivers.
  int smoothing = 2;
};

// The surface between the inside (value < 0) and the outside (value >= 0). Seen from outside, the
// corners of each triangle are in counter-clockwise order. `value` is called from several threads
// at once. A body that reaches the border of the box is closed there. The mesh is empty if the
// function is nowhere negative in the box, or if the box is empty.
TriangleMesh polygonise(const ScalarFunction& value, const Aabb& box,
                        const PolygoniseSettings& settings = {});

}  // namespace resect
