// 01: a closed mesh becomes particles.
//
// A lattice of cubic cells is laid over the mesh. A cell whose centre is inside is a particle;
// every cell also knows how many per cent of it are tissue, so that the volume is right at any
// spacing, not only at a fine one.

#include <fmt/core.h>

#include <cmath>

#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "organ/discretize.h"

using namespace resect;

int main() {
  // Any closed mesh that looks outwards will do; readModel (example 06) gets one from a file.
  const TriangleMesh mesh = sphereMesh({0, 0, 0}, 0.05, 48);
  const double meshVolume = volume(mesh);
  fmt::print("mesh: {} triangles, {:.1f} ml\n", mesh.triangles.size(), 1e6 * meshVolume);

  bool good = true;
  for (const double spacing : {0.010, 0.005, 0.0025}) {
    const Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), spacing));
    const double byCounting = double(cells.particleCount()) * cells.lattice.cellVolume();
    const double byShares = cells.volume();
    fmt::print(
        "spacing {:3.1f} mm: {:6} particles; volume {:.1f} ml by shares ({:+.2f} %), {:.1f} ml by "
        "counting particles ({:+.2f} %)\n",
        1e3 * spacing, cells.particleCount(), 1e6 * byShares, 100 * (byShares / meshVolume - 1),
        1e6 * byCounting, 100 * (byCounting / meshVolume - 1));
    good = good && cells.particleCount() > 0 && std::abs(byShares / meshVolume - 1) < 0.01;
  }
  return good ? 0 : 1;
}
