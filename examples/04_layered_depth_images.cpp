// 04: do two bodies collide, where, and how much of one is in the other?
//
// Three stages, as in the thesis this program goes back to: the boxes give the volume of interest,
// both bodies become layered depth images in it, and the images are intersected pixel by pixel. The
// result is a volume, and an exact answer for any single point.

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "collision/collider.h"
#include "geometry/primitives.h"

using namespace resect;

int main() {
  const double r = 0.03, distance = 0.04;
  Collider collider;
  collider.setObject(Collider::First, sphereMesh({0, 0, 0}, r, 96));
  collider.setObject(Collider::Second, sphereMesh({distance, 0, 0}, r, 96));
  if (!collider.generateVolumeOfInterest()) return 1;
  const Vec3 size = 1e3 * collider.volumeOfInterest().size();
  fmt::print("volume of interest: {:.1f} x {:.1f} x {:.1f} mm\n", size.x(), size.y(), size.z());

  // The common part of two equal balls is a lens of two caps of this height.
  const double height = r - distance / 2;
  const double lens = 2 * std::numbers::pi * height * height * (3 * r - height) / 3;
  double error = 1;
  for (const int resolution : {16, 64, 256}) {
    collider.generateLayeredDepthImages(resolution);
    collider.generateIntersectionVolume();
    const LayeredDepthImage& overlap = collider.ldi(Collider::Intersection);
    error = overlap.volume() / lens - 1;
    fmt::print("{:3} x {:3} pixels: {:.3f} ml, {:+.2f} % of the exact {:.3f} ml\n",
               overlap.columnsX(), overlap.columnsY(), 1e6 * overlap.volume(), 100 * error,
               1e6 * lens);
  }

  const LayeredDepthImage& overlap = collider.ldi(Collider::Intersection);
  const bool middle = overlap.isInside({distance / 2, 0, 0});
  const bool first = overlap.isInside({0, 0, 0});  // in the first ball only
  fmt::print("between the centres: {}; centre of the first: {}\n", middle ? "in both" : "not",
             first ? "in both" : "not");
  return std::abs(error) < 0.01 && middle && !first ? 0 : 1;
}
