#include "tissue/elastic/uneven_cells.h"

#include <Eigen/Eigenvalues>

namespace resect {

// Along the normal of the joint the stress of both materials is the same, so the strain of the
// other one is that of the own one times the quotient E / E' of Young's moduli. The two ends of a
// bond across the joint are half in either. So the mean over the bonds sees a share of the own
// strain that is a mean of (1 + E / E') / 2.
MaterialJoint jointAt(const ElasticState& s, std::int32_t i) {
  const TissueMaterial& own = s.materials[s.material[i]];
  const std::array<double, 4> weights = bondWeights();
  MaterialJoint joint;
  joint.shear = own.shear();
  Mat3 others = Mat3::Zero();
  double softness = 1 / own.shear();
  int cells = 1;
  for (int d = 0; d < kDirections; ++d) {
    if (!(s.bonds[i] >> d & 1)) continue;
    const std::int32_t j = i + s.box.step[d];
    softness += 1 / s.materials[s.material[j]].shear();
    ++cells;
    if (s.material[j] == s.material[i]) continue;
    const Vec3 x = offsetOf(d).cast<double>();
    others += weights[neighbourKind(d)] * x * x.transpose();
  }
  if (others.isZero()) return joint;
  joint.shear = cells / softness;
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Mat3>(others).eigenvectors().col(2);
  double all = 0, seen = 0;
  for (int d = 0; d < kDirections; ++d) {
    if (!(s.bonds[i] >> d & 1)) continue;
    const double along = normal.dot(offsetOf(d).cast<double>());
    const double weight = weights[neighbourKind(d)] * along * along;
    const TissueMaterial& there = s.materials[s.material[i + s.box.step[d]]];
    all += weight;
    seen += weight * (1 + own.young / there.young) / 2;
  }
  joint.toOwn += (std::sqrt(all / seen) - 1) * normal * normal.transpose();
  return joint;
}

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
