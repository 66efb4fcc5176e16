// Which points lie inside a body that is blended from ellipsoids?
//
// The body is made like clay: ellipsoids are added to it or carved out of it one after the other,
// each with a fillet of its own width where it meets what is already there. The result is a signed
// value in metres, negative inside; near the surface it is close to the distance, and it is smooth
// (C2) but for the ellipsoids' centres, where it jumps by less than their largest radius. Cost: two
// square roots and two divisions an ellipsoid; allocates nothing; safe from several threads.
//
// Sources: blending of implicit bodies, A. Ricci (1973); cubic smooth minimum and first-order
// distance of an ellipsoid, I. Quilez (articles "smooth minimum", "ellipsoid distance", 2013).
#pragma once

#include <span>

#include "base/vec.h"

namespace resect {

// How an ellipsoid changes the body that the ones before it made.
enum class Blend { Add, Carve };

struct BlendedEllipsoid {
  Blend blend = Blend::Add;
  Vec3 centre = Vec3::Zero();           // m
  Eigen::Vector4d turn = {0, 0, 0, 1};  // quaternion x, y, z, w: from its own axes to the body's
  Vec3 radii = Vec3::Constant(0.01);    // m, each > 0
  double fillet = 0.01;                 // m, > 0: width over which it melts into the body
};

class BlendedShape {
 public:
  static constexpr int kMost = 64;  // ellipsoids

  // At most kMost ellipsoids, in the order in which they are blended.
  explicit BlendedShape(std::span<const BlendedEllipsoid> ellipsoids);

  // Signed value at p (m), m; a shape of nothing is infinitely far from every point.
  double operator()(const Vec3& p) const;

 private:
  using Row = Eigen::Array<double, Eigen::Dynamic, 1, 0, kMost, 1>;  // one number an ellipsoid

  // Row m of the map to the unit ball is toUnit_[m]; offset_ is where it takes the origin.
  Row toUnit_[3][3], offset_[3], inverseRadii_[3], fillet_, sign_;
};

}  // namespace resect
