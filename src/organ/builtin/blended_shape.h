// A body blended from ellipsoids, as a signed function.
//
// Ellipsoids are added to the body or carved out of it one after the other, each with a fillet of
// its own width. The value is signed, in metres, negative inside; near the surface it approximates
// the distance. It is smooth (C2) except at the ellipsoids' centres, where it jumps by less than
// their largest radius. Cost: two square roots and two divisions per ellipsoid; allocates nothing;
// thread-safe.
//
// Sources: blending of implicit bodies, A. Ricci (1973); cubic smooth minimum and first-order
// distance of an ellipsoid, I. Quilez (articles "smooth minimum", "ellipsoid distance", 2013).
#pragma once

#include <span>

#include "base/vec.h"

namespace resect {

// How an ellipsoid changes the body made by those before it.
enum class Blend { Add, Carve };

struct BlendedEllipsoid {
  Blend blend = Blend::Add;
  Vec3 centre = Vec3::Zero();           // m
  Eigen::Vector4d turn = {0, 0, 0, 1};  // quaternion x, y, z, w: from its own axes to the body's
  Vec3 radii = Vec3::Constant(0.01);    // m, each > 0
  double fillet = 0.01;                 // m, > 0: width of the blend with the body
};

class BlendedShape {
 public:
  static constexpr int kMost = 64;  // ellipsoids

  // At most kMost ellipsoids, in the order in which they are blended.
  explicit BlendedShape(std::span<const BlendedEllipsoid> ellipsoids);

  // Signed value, m, at the point p, m. A shape without ellipsoids has the value infinity
  // everywhere.
  double operator()(const Vec3& p) const;

 private:
  using Row = Eigen::Array<double, Eigen::Dynamic, 1, 0, kMost, 1>;  // a number per ellipsoid

  // The affine map of each ellipsoid to the unit ball: toUnit_[m] is row m of its linear part,
  // offset_ the image of the origin.
  Row toUnit_[3][3], offset_[3], inverseRadii_[3], fillet_, sign_;
};

}  // namespace resect
