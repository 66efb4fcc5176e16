#include "tissue/elastic/contact/dent.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr int kSteps = 40;           // towards the way out
constexpr double kClose = 0.01;      // of a width: distance from the border that ends the search
constexpr double kLeastSlope = 0.5;  // of the distance along the way, for a step of Newton's

}  // namespace

// A patch at the edge of a flat face is covered in part. So the obstacle is taken half a width
// larger, and the share grows from 0 at that border to 1 a width further inside. Patches beside
// each other then cover the face exactly, wherever they lie.
Dent dentIn(const SignedDistance& shape, const Vec3& place, const Vec3& inwards, double width,
            const WayOut& limits) {
  const double half = 0.5 * width, larger = limits.margin + half;
  const Vec3 start = place + limits.margin * inwards;
  SignedDistance::Sample sample = shape(start);
  if (sample.distance >= larger) return {};
  double way = 0;
  for (int k = 0; k < kSteps && std::abs(sample.distance - larger) > kClose * width; ++k) {
    const double slope = sample.outwards.dot(inwards);
    way -= (sample.distance - larger) / (slope > kLeastSlope ? slope : 1);
    if (way > limits.farthest + half) return {};
    sample = shape(start + way * inwards);
  }
  const double slope = sample.outwards.dot(inwards);
  if (way > limits.deepest + half) {
    if (slope < limits.leastSlope || sample.distance < larger - kClose * width) return {};
    return {limits.deepest, inwards, 1};
  }
  Dent dent;
  dent.outwards = sample.outwards;
  dent.depth = std::min(limits.deepest, way * std::max(0.0, slope) - half);
  if (dent.depth <= 0) return {};
  const double within = larger - shape(start + (way - width) * inwards).distance;
  dent.share = std::clamp(within / width, 0.0, 1.0);
  return dent;
}

}  // namespace resect
