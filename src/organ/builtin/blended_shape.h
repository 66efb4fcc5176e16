// A body blended from ellipsoids, as a signed function.
//
// Ellipsoids are added to the body or carved out of it, one after the other. The seam between body
// and ellipsoid is rounded by a fillet. Each ellipsoid's fillet has a width of its own. The
// function's value is in metres, and negative inside the body; near the surface it approximates the
// distance to the surface. The function is smooth (C2) except at the centre of each ellipsoid.
// There its value jumps, by at most the largest radius of this ellipsoid. Cost: two square roots
// and two divisions per ellipsoid; allocates nothing; thread-safe.
//
// Sources: blending of implicit bodies, A. Ricci (1973); cubic smooth minimum and first-order
// distance of an ellipsoid, I. Quilez (articles "smooth minimum", "ellipsoid distance", 2013).
#pragma once

#include <span>

#include "base/vec.h"

namespace resect {

// Whether an ellipsoid is added to the body made by the ellipsoids before it, or carved out of it.
enum class Blend { Add, Carve };

struct BlendedEllipsoid {
  Blend blend = Blend::Add;
  Vec3 centre = Vec3::Zero();  // m
  // Rotation from the ellipsoid's own axes to the body's axes, as a quaternion x, y, z, w.
  Eigen::Vector4d turn = {0, 0, 0, 1};
  Vec3 radii = Vec3::Constant(0.01);  // m, each > 0
  double fillet = 0.01;               // m, > 0: width of the blend with the body
};

class BlendedShape {
 public:
  static constexpr int kMost = 64;  // greatest number of ellipsoids

  // ellipsoids: at most kMost, in the order in which they are blended.
  explicit BlendedShape(std::span<const BlendedEllipsoid> ellipsoids);

  // The value, m, at the point p, m. A shape without ellipsoids has the value infinity everywhere.
  double operator()(const Vec3& p) const;

 private:
  using Row = Eigen::Array<double, Eigen::Dynamic, 1, 0, kMost, 1>;  // one number per ellipsoid

  // An affine map takes each ellipsoid to the unit ball. toUnit_[m][n] is entry (m, n) of the map's
  // matrix. offset_[m] is coordinate m of the point to which the map takes the origin.
  Row toUnit_[3][3], offset_[3], inverseRadii_[3], fillet_, sign_;
};

}  // namespace resect
