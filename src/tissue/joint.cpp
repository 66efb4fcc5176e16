#include "tissue/joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace resect {

std::vector<TissueJoint> joinNear(const JoinedOrgan& a, const JoinedOrgan& b, double reach,
                                  double stiffness, double shortest) {
  require(
      reach >= 0 && stiffness >= 0 && shortest > 0 && std::isfinite(reach) &&
          std::isfinite(stiffness),
      "springs of {} N/m within {} m, for substeps of {} s, were asked for; give finite numbers "
      "from 0, and a substep above it",
      stiffness, reach, shortest);
  std::vector<TissueJoint> joints;
  const Lattice &from = *a.lattice, &to = *b.lattice;
  const Vec3i cells = (Vec3::Constant(reach).cwiseQuotient(to.spacing)).array().ceil().cast<int>();
  for (std::int64_t cell = 0; cell < from.cellCount(); ++cell) {
    if (!a.tissue->solid(cell)) continue;
    const Vec3 centre = from.centre(from.cell(cell));
    const Vec3i middle = to.toCellSpace(centre).array().round().cast<int>();
    const Vec3i low = (middle - cells).cwiseMax(0);
    const Vec3i high = (middle + cells).cwiseMin(to.dims - Vec3i::Ones());
    std::int64_t nearest = -1;
    double distance = reach * reach;
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          const std::int64_t other = to.index({x, y, z});
          const double d = (to.centre({x, y, z}) - centre).squaredNorm();
          if (d > distance || (d == distance && nearest >= 0) || !b.tissue->solid(other)) continue;
          nearest = other;
          distance = d;
        }
    if (nearest < 0) continue;
    TissueJoint joint;
    joint.organ = {a.number, b.number};
    joint.cell = {cell, nearest};
    joint.rest = to.centre(to.cell(nearest)) - centre;
    joints.push_back(joint);
  }
  std::vector<std::int64_t> ends;  // cells of `b`, repeated for each spring
  for (const TissueJoint& joint : joints) ends.push_back(joint.cell[1]);
  std::ranges::sort(ends);
  for (TissueJoint& joint : joints) {
    // Springs at the same cell share its mass: together they must stay stable too.
    double lighter = std::numeric_limits<double>::infinity();
    if (const double mass = a.tissue->mass(joint.cell[0]); mass > 0) lighter = mass;
    if (const double mass = b.tissue->mass(joint.cell[1]); mass > 0)
      lighter =
          std::min(lighter, mass / double(std::ranges::equal_range(ends, joint.cell[1]).size()));
    if (!std::isfinite(lighter)) continue;  // neither end moves
    joint.stiffness =
        std::min(stiffness / double(joints.size()), 0.1 * lighter / (shortest * shortest));
    joint.damping = 0.5 * std::sqrt(joint.stiffness * lighter);
  }
  return joints;
}

void pullJoints(std::span<const TissueJoint> joints, std::span<const JoinedOrgan> organs) {
  for (const TissueJoint& joint : joints) {
    const JoinedOrgan& a = organs[std::size_t(joint.organ[0])];
    const JoinedOrgan& b = organs[std::size_t(joint.organ[1])];
    const auto [p, q] = joint.cell;
    const Vec3 stretch = b.tissue->displacement(q) - a.tissue->displacement(p);
    const Vec3 force =
        joint.stiffness * stretch + joint.damping * (b.tissue->velocity(q) - a.tissue->velocity(p));
    a.tissue->pull(p, force);
    b.tissue->pull(q, -force);
  }
}

}  // namespace resect
