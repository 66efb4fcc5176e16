#include "tissue/elastic/uneven_bonds.h"

namespace resect {

std::vector<UnevenBond> findUnevenBonds(const ElasticState& s) {
  const std::array<double, 4> weights = bondWeights();
  std::vector<UnevenBond> bonds;
  for (const TissueChunk& chunk : s.chunks) {
    if (!chunk.uneven) continue;
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i)
      for (int d = kFirstForward; d < kDirections; ++d) {
        if (!(s.bonds[i] >> d & 1)) continue;
        const std::int32_t j = i + s.box.step[d];
        const double difference = double(s.kappa[j]) - s.kappa[i];
        if (difference == 0) continue;
        const double weight = weights[neighbourKind(d)] / (s.spacing * s.spacing);
        bonds.push_back({i, j, float(weight * difference)});
      }
  }
  return bonds;
}

// kappa_a + kappa_b is 2 kappa_a + (kappa_b - kappa_a) for one end and 2 kappa_b - (kappa_b -
// kappa_a) for the other, whose displacement difference has the opposite sign.
void pullUnevenBonds(std::span<const UnevenBond> bonds, ElasticState& s) {
  for (const UnevenBond& bond : bonds)
    for (int k = 0; k < 3; ++k) {
      const float force = bond.stiffness * (s.ahead[k][bond.b] - s.ahead[k][bond.a]);
      s.bondForce[k][bond.a] += force;
      s.bondForce[k][bond.b] += force;
    }
}

}  // namespace resect
