// The affine motion of the tissue round a particle (a cell of tissue). A point with rest position X
// is displaced by shift + gradient * X. Here `gradient` is F - I, and F is the deformation
// gradient. A vertex that follows several particles has the weighted mean of their motions.
#pragma once

#include "base/vec.h"

namespace resect {

struct ParticleMotion {
  Column shift{}, gradient[3]{};  // shift: m; gradient: the three columns of F - I
};

// The motion round one particle. rest: the particle's rest position, m. displacement: the
// particle's displacement, m. gradient: F - I at the particle.
inline ParticleMotion particleMotion(const Vec3f& rest, const Vec3f& displacement,
                                     const Eigen::Matrix3f& gradient) {
  return {column(displacement - gradient * rest),
          {column(gradient.col(0)), column(gradient.col(1)), column(gradient.col(2))}};
}

// Adds share * motion to `sum`.
inline void add(ParticleMotion& sum, float share, const ParticleMotion& motion) {
  const Column weight = share - Column{};
  sum.shift += weight * motion.shift;
  for (int a = 0; a < 3; ++a) sum.gradient[a] += weight * motion.gradient[a];
}

// The displacement, m, of the point with rest position X.
inline Column displacementAt(const ParticleMotion& motion, const Vec3f& X) {
  const Column* g = motion.gradient;
  return motion.shift + (g[0] * X.x() + g[1] * X.y() + g[2] * X.z());
}

}  // namespace resect
