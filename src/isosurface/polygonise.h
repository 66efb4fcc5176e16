// Triangle mesh of the zero surface of a function.
//
// The function is sampled on a body-centred cubic lattice, whose tetrahedra are congruent and
// nearly regular; each crossed tetrahedron gives one or two triangles, so the result is closed,
// oriented and manifold for any function. The mesh is then smoothed, and edges that cut off a sharp
// margin are split (isosurface/relax.h). Cost: 1.5 evaluations a cubic lattice cell and about 30 a
// point; same bits at any number of threads.
//
// Sources: marching tetrahedra, Doi, Koide (1991); the lattice, Labelle, Shewchuk (2007).
#pragma once

#include <limits>

#include "geometry/triangle_mesh.h"
#include "isosurface/relax.h"

namespace resect {

struct PolygoniseSettings {
  // m, > 0: longest edge of most triangles; the mean is three quarters of it. Parts thinner than
  // that may be lost.
  double edge = 0.0025;
  // Lipschitz constant of the function: boxes whose value is too far from zero are skipped as a
  // whole. Infinite: nothing is skipped. Too small: parts of the surface are lost.
  double lipschitz = std::numeric_limits<double>::infinity();
  // Rounds of smoothing and splitting; 0 leaves the triangles as the lattice makes them, slivers
  // included.
  int smoothing = 2;
};

// The surface between value < 0 (inside) and value >= 0 (outside), counter-clockwise seen from
// outside. `value` is called from several threads at once. A body that reaches the border of the
// box is closed there. An empty mesh where the function has one sign only, or the box is empty.
TriangleMesh polygonise(const ScalarFunction& value, const Aabb& box,
                        const PolygoniseSettings& settings = {});

}  // namespace resect
