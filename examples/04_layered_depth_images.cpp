// 04: whether two bodies collide, where, and the volume that they share.
//
// Three stages, as in the thesis this program goes back to: the boxes give the volume of interest,
// both bodies become layered depth images in it, and the images are intersected pixel by pixel. The
// result is a volume; for single points there is an exact answer. An instrument in an organ goes
// the same way: src/tools/contacts.cpp.

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "collision/collider.h"
#include "collision/inside.h"
#include "geometry/primitives.h"

using namespace resect;

int main() {
  const double r = 0.03, distance = 0.04;
  const TriangleMesh a = sphereMesh({0, 0, 0}, r, 96), b = sphereMesh({distance, 0, 0}, r, 96);
  const Aabb common = intersection(bounds(a), bounds(b));
  if (common.empty()) return 1;
  const Vec3 size = 1e3 * common.size();
  fmt::print("volume of interest: {:.1f} x {:.1f} x {:.1f} mm\n", size.x(), size.y(), size.z());

  // The common part of two equal balls is a lens of two caps of this height.
  const double height = r - distance / 2;
  const double lens = 2 * std::numbers::pi * height * height * (3 * r - height) / 3;
  double error = 1;
  for (const int resolution : {16, 64, 256}) {
    const ColumnGrid pixels = pixelsOver(common, resolution);
    const double overlap = volume(intersectionVolume(layeredDepthImage(a, common, pixels),
                                                     layeredDepthImage(b, common, pixels)));
    error = overlap / lens - 1;
    fmt::print("{:3} x {:3} pixels: {:.3f} ml, {:+.2f} % of the exact {:.3f} ml\n", pixels.countX,
               pixels.countY, 1e6 * overlap, 100 * error, 1e6 * lens);
  }

  // Between the centres, and at the centre of the first ball, which is not in the second.
  const std::vector<Vec3> points{{distance / 2, 0, 0}, {0, 0, 0}};
  const auto inA = insideFlags(a, points), inB = insideFlags(b, points);
  const bool middle = inA[0] && inB[0], first = inA[1] && inB[1];
  fmt::print("between the centres: {}; centre of the first: {}\n", middle ? "in both" : "not",
             first ? "in both" : "not");
  return std::abs(error) < 0.01 && middle && !first ? 0 : 1;
}
