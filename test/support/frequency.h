// The highest frequency of small motions of elastic tissue.
#pragma once

#include <cmath>
#include <vector>

#include "support/tissue_blocks.h"

namespace resect::test {

// The highest frequency of small motions about the displacements `u`, 1/s: power iteration on the
// change of the forces.
inline double highestFrequency(ElasticTissue& tissue, const std::vector<std::int64_t>& cells,
                               const std::vector<Vec3>& u) {
  constexpr int kIterations = 120;
  const double small = 0.002 * tissue.lattice().spacing.x();
  const auto forcesAt = [&](const std::vector<Vec3>& away, double scale) {
    for (std::size_t k = 0; k < cells.size(); ++k)
      tissue.setDisplacement(cells[k], u[k] + scale * away[k]);
    tissue.evaluateForces();
    std::vector<Vec3> forces;
    for (const std::int64_t c : cells) forces.push_back(tissue.elasticForce(c));
    return forces;
  };
  Random random(3);
  std::vector<Vec3> mode(cells.size());
  for (Vec3& v : mode) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  const std::vector<Vec3> rest = forcesAt(mode, 0);
  double squared = 0;
  for (int i = 0; i < kIterations; ++i) {
    double largest = 0, norm = 0, work = 0;
    for (const Vec3& v : mode) largest = std::max(largest, v.norm());
    for (Vec3& v : mode) norm += (v /= largest).squaredNorm();
    const std::vector<Vec3> forces = forcesAt(mode, small);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const Vec3 next = (rest[k] - forces[k]) / (small * tissue.mass(cells[k]));
      work += next.dot(mode[k]);
      mode[k] = next;
    }
    squared = work / norm;
  }
  return std::sqrt(squared);
}

}  // namespace resect::test
