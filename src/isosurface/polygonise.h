// What triangles stand for the surface where a function is zero?
//
// The function is sampled on a body-centred cubic lattice, whose tetrahedra are all alike and
// nearly regular; each tetrahedron that the surface crosses gives one or two triangles, so the
// result is closed, oriented and manifold by construction, whatever the function does. The mesh is
// then evened out, and edges that cut off a sharp margin are split (isosurface/relax.h). Cost: 1.5
// evaluations a cubic lattice cell and about 30 a point; same bits at any number of threads.
//
// Sources: marching tetrahedra, Doi, Koide (1991); the lattice, Labelle, Shewchuk (2007).
#pragma once

#include <limits>

#include "geometry/triangle_mesh.h"
#include "isosurface/relax.h"

namespace resect {

struct PolygoniseSettings {
  // m, > 0: longest edge of most triangles; the mean is three quarters of it. Places thinner than
  // it may get lost.
  double edge = 0.0025;
  // Most that the function changes a metre: boxes that are too far from zero are skipped as a
  // whole. Infinite: nothing is skipped. Too small: pieces of the surface are lost.
  double lipschitz = std::numeric_limits<double>::infinity();
  // Rounds of evening out and splitting; 0 leaves the triangles, slivers too, as the lattice cuts
  // them.
  int smoothing = 2;
};

// The surface between value < 0 (inside) and value >= 0 (outside), counter-clockwise seen from
// outside. `value` is called from several threads at once. A body that reaches the border of the
// box is closed there. An empty mesh where the function has one sign only, or the box is empty.
TriangleMesh polygonise(const ScalarFunction& value, const Aabb& box,
                        const PolygoniseSettings& settings = {});

}  // namespace resect
