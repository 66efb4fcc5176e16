// Closed meshes of the worst kind.
#pragma once

#include <cmath>

#include "base/random.h"
#include "geometry/primitives.h"

namespace resect {

// A closed oriented mesh with points on a coarse raster: full of coplanar, edge-on, zero-area and
// overlapping triangles. Starts as a box, torus or sphere whose points are then thrown about.
inline TriangleMesh randomDegenerateMesh(Random& random) {
  TriangleMesh mesh;
  switch (random.below(3)) {
    case 0:
      mesh = boxMesh({{0, 0, 0}, {8, 8, 8}});
      break;
    case 1:
      mesh = sphereMesh({4, 4, 4}, 4, 2 + random.below(4));
      break;
    default:
      mesh = torusMesh({4, 4, 4}, 3, 1, 3 + random.below(5), 3 + random.below(4));
  }
  const int wildness = random.below(4);
  for (Vec3& p : mesh.points) {
    if (wildness == 1) p = p.array().round();
    if (wildness == 2) p = Vec3(random.below(9), random.below(9), random.below(9));
    if (wildness == 3 && random.below(3) == 0)
      p = Vec3(random.uniform(0, 8), random.below(9), 1e-9 * random.below(9));
  }
  if (random.below(3) == 0) append(mesh, boxMesh({{1, 2, 3}, {5, 6, 7}}));
  return mesh;
}

// Several of them, in one place: shells that overlap and touch.
inline TriangleMesh randomDegenerateShells(Random& random, int shells) {
  TriangleMesh mesh;
  for (int n = 0; n < shells; ++n) append(mesh, randomDegenerateMesh(random));
  return mesh;
}

}  // namespace resect
