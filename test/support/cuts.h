// Cuts through whole organs, as edits, without an instrument.
#pragma once

#include "simulation/simulation.h"
#include "support/blades.h"
#include "tissue/stencil.h"

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
  Incision incision{flatBlade(foot, far * a, far * b), {}};
  const auto height = [&](std::int64_t cell) {
    return plane.normal.dot(lattice.centre(lattice.cell(cell))) - plane.offset;
  };
  FrameInput input;
  for (const ToolState& tool : simulation.tools()) input.tools.push_back({tool.pose(), false});
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) {
    if (!simulation.organ().alive[std::size_t(cell)]) continue;
    if (std::abs(height(cell)) < 3 * lattice.spacing.maxCoeff()) incision.cells.push_back(cell);
    const std::uint32_t bonds = simulation.tissue().bonds(cell);
    for (int d = kFirstForward; d < kDirections; ++d) {
      if (!(bonds >> d & 1)) continue;
      const std::int64_t other = lattice.index(lattice.cell(cell) + offsetOf(d));
      if (crossing(incision.blade, lattice.centre(lattice.cell(cell)),
                   lattice.centre(lattice.cell(other))))
        input.edits.push_back({0, -1, SeverBond{cell, d}});
    }
  }
  input.edits.push_back({0, -1, std::move(incision)});
  input.duration = 0;
  simulation.step(input);
}

}  // namespace resect::test
