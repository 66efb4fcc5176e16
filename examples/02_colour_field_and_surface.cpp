// 02: particles make a colour field, and the field makes the surface that is seen.
//
// The field is the smoothed amount of tissue: about 100 inside, 0 outside. The surface is where it
// passes the iso level; half way (50) keeps the volume, lower swells the organ, higher shrinks it.

#include <fmt/core.h>

#include <cmath>

#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "organ/organ.h"

using namespace resect;

int main() {
  const TriangleMesh mesh = torusMesh({0, 0, 0}, 0.05, 0.02);
  Organ organ = makeOrgan(discretize(mesh, latticeForSpacing(bounds(mesh), 0.004)), {});

  // The field along a line through the tube of the torus, from its axis outwards.
  const ColourField& field = organ.field;
  const Vec3 perNode = field.lattice().spacing / field.refine();
  for (double x = 0; x <= 0.0801; x += 0.01) {
    const Vec3 node = (Vec3(x, 0, 0) - field.nodePosition(Vec3::Zero())).cwiseQuotient(perNode);
    fmt::print("x = {:2.0f} mm: colour {:5.1f}\n", 1e3 * x,
               field.node(node.array().round().cast<int>()));
  }

  bool good = true;
  double last = 1;
  for (const float iso : {20.f, 50.f, 80.f}) {
    organ.surface.setIso(organ.field, iso);
    const TriangleMesh surface = organ.surface.mesh();
    const Topology skin = topology(surface);
    fmt::print("iso {}: {} triangles, {}, {:.1f} ml (the mesh: {:.1f} ml)\n", iso,
               surface.triangles.size(), skin.closed() ? "closed" : "open", 1e6 * volume(surface),
               1e6 * volume(mesh));
    good = good && skin.closed() && skin.oriented() && skin.components == 1;
    good = good && volume(surface) < last;
    if (iso == 50) good = good && std::abs(volume(surface) / volume(mesh) - 1) < 0.03;
    last = volume(surface);
  }
  return good ? 0 : 1;
}
