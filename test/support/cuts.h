// Cuts through whole organs, as edits, without an instrument.
#pragma once

#include "simulation/simulation.h"
#include "support/blades.h"

namespace resect::test {

// The points p with normal . p = offset; normal: unit.
struct Plane {
  Vec3 normal = Vec3::UnitX();
  double offset = 0;
};

// Cuts the first organ along the whole plane, as a blade would, in its places at rest.
inline void cutAlong(Simulation& simulation, const Plane& plane) {
  const Lattice& lattice = simulation.organ().rest.lattice;
  const Vec3 a = plane.normal.unitOrthogonal(), b = plane.normal.cross(a);
  const Vec3 middle = lattice.box().centre();
  const Vec3 foot = middle + (plane.offset - plane.normal.dot(middle)) * plane.normal;
  const double far = lattice.box().size().norm();
  FrameInput input;
  for (const ToolState& tool : simulation.tools()) input.tools.push_back({tool.pose(), false});
  input.edits.push_back({0, -1, Incision{flatBlade(foot, far * a, far * b)}});
  input.duration = 0;
  simulation.step(input);
}

}  // namespace resect::test
