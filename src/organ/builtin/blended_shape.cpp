#include "organ/builtin/blended_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace resect {

BlendedShape::BlendedShape(std::span<const BlendedEllipsoid> ellipsoids) {
  require(ellipsoids.size() <= std::size_t(kMost), "a shape of {} ellipsoids is too much; give {}",
          ellipsoids.size(), kMost);
  const auto count = Eigen::Index(ellipsoids.size());
  for (int m = 0; m < 3; ++m) {
    for (int n = 0; n < 3; ++n) toUnit_[m][n].resize(count);
    offset_[m].resize(count);
    inverseRadii_[m].resize(count);
  }
  fillet_.resize(count);
  sign_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const BlendedEllipsoid& e = ellipsoids[std::size_t(i)];
    require((e.radii.array() > 0).all() && e.fillet > 0,
            "ellipsoid {} has radii {}, {}, {} m and fillet {} m; give lengths above 0", i,
            e.radii.x(), e.radii.y(), e.radii.z(), e.fillet);
    const Vec3 inverse = e.radii.cwiseInverse();
    const Mat3 map = inverse.asDiagonal() *
                     Eigen::Quaterniond(e.turn).normalized().toRotationMatrix().transpose();
    const Vec3 offset = -map * e.centre;
    for (int m = 0; m < 3; ++m) {
      for (int n = 0; n < 3; ++n) toUnit_[m][n][i] = map(m, n);
      offset_[m][i] = offset[m];
      inverseRadii_[m][i] = inverse[m];
    }
    fillet_[i] = e.fillet;
    sign_[i] = e.blend == Blend::Carve ? -1 : 1;
  }
}

double BlendedShape::operator()(const Vec3& p) const {
  // All ellipsoids at once: |q| is 1 on the ellipsoid; |q| (|q| - 1) / |q / radii| approximates the
  // distance.
  Row k0 = Row::Zero(fillet_.size()), k1 = Row::Zero(fillet_.size());
  for (int m = 0; m < 3; ++m) {
    const Row q =
        toUnit_[m][0] * p.x() + toUnit_[m][1] * p.y() + toUnit_[m][2] * p.z() + offset_[m];
    k0 += q.square();
    k1 += (q * inverseRadii_[m]).square();
  }
  k0 = k0.sqrt();
  const Row ellipsoid = k0 * (k0 - 1) / k1.sqrt().max(1e-9);

  // Blended one after the other; carving is adding to the outside.
  double value = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < ellipsoid.size(); ++i) {
    const double body = sign_[i] * value, width = fillet_[i];
    const double overlap = std::max(width - std::abs(body - ellipsoid[i]), 0.0);
    const double fillet = overlap == 0 ? 0 : overlap * overlap * overlap / (6 * width * width);
    value = sign_[i] * (std::min(body, ellipsoid[i]) - fillet);
  }
  return value;
}

}  // namespace resect
