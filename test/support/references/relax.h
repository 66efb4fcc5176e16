// Static equilibrium of a tissue by kinetic damping: it swings freely until its kinetic energy has
// passed a peak, where all motion is taken out; the peaks fall off fast (Cundall 1976).
#pragma once

#include "tissue/elastic/elastic_tissue.h"

namespace resect::test {

inline double kineticEnergy(const ElasticTissue& tissue) {
  const ElasticState& s = tissue.state();
  double sum = 0;
  for (const TissueChunk& chunk : s.chunks)
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i)
      for (int a = 0; a < 3; ++a)
        if (s.solid[i] && !(s.held[i] >> a & 1))
          sum += 0.5 * double(s.v[a][i]) * s.v[a][i] / s.inverseMass[i];
  return sum;
}

inline void stopMotion(ElasticTissue& tissue) {
  tissue.stopMotion();  // of boundary cells too
  for (std::int64_t c = 0; c < tissue.lattice().cellCount(); ++c)
    if (tissue.solid(c)) tissue.setVelocity(c, Vec3::Zero());
}

// Until a peak of the kinetic energy is below `share` of the elastic energy. Returns substeps;
// `most` when it did not come to rest.
inline int relax(ElasticTissue& tissue, double share = 1e-7, int most = 40000) {
  constexpr int kBetweenLooks = 4;
  const double duration = 0.999 * kBetweenLooks * tissue.longestSubstep();
  double before = 0;
  for (int n = 0; n < most; n += kBetweenLooks) {
    tissue.advance(duration);
    const double now = kineticEnergy(tissue);
    if (now < before) {
      stopMotion(tissue);
      if (before < share * std::abs(tissue.energy().elastic)) return n;
      before = 0;
    } else {
      before = now;
    }
  }
  return most;
}

}  // namespace resect::test
