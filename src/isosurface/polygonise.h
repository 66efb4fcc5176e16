// Triangle mesh of the zero surface of a function.
//
// The function is sampled on a body-centred cubic lattice, whose tetrahedra are congruent and
// nearly regular. Each crossed tetrahedron gives one or two triangles, so the mesh is closed,
// oriented and manifold for any function. The mesh is then smoothed, and edges that cut off a sharp
// margin of the body are split (isosurface/relax.h). Cost: 1.5 evaluations of the function per cube
// of the lattice and about 30 per point. Same bits at any number of threads.
//
// Sources: marching tetrahedra, Doi, Koide (1991); the lattice, Labelle, Shewchuk (2007).
#pragma once

#include <limits>

#include "geometry/triangle_mesh.h"
#include "isosurface/relax.h"

namespace resect {

struct PolygoniseSettings {
  // Longest edge of most triangles, m, > 0; the mean edge is three quarters of it. Parts of the
  // body that are thinner than `edge` may be lost.
  double edge = 0.0025;
  // Lipschitz constant of the function. With it a box is skipped as a whole if the value at its
  // centre is too far from zero for the surface to reach the box. Infinite: nothing is skipped. Too
  // small: parts of the surface are lost.
  double lipschitz = std::numeric_limits<double>::infinity();
  // Rounds of smoothing and splitting; 0 leaves the triangles as the lattice makes them, slivers
  // included.
  int smoothing = 2;
};

// The surface between value < 0 (inside) and value >= 0 (outside), with triangles that are
// counter-clockwise seen from outside. `value` is called from several threads at once. A body that
// reaches the border of the box is closed there. The mesh is empty if the function is nowhere
// negative in the box, or if the box is empty.
TriangleMesh polygonise(const ScalarFunction& value, const Aabb& box,
                        const PolygoniseSettings& settings = {});

}  // namespace resect
