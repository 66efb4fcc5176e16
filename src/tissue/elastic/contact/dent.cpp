#include "tissue/elastic/contact/dent.h"

#include <algorithm>

namespace resect {
namespace {

constexpr int kSteps = 4;            // towards the way out
constexpr double kLeastSlope = 0.5;  // of the distance along the way, for a step of Newton's

}  // namespace

// A patch at the edge of a flat face is covered in part. So the obstacle is taken half a width
// larger, and the share grows from 0 at that border to 1 a width further inside. Patches beside
// each other then cover the face exactly, wherever they lie.
Dent dentIn(const SignedDistance& shape, const Vec3& place, const Vec3& inwards, double width,
            double deepest) {
  Dent dent;
  const double larger = 0.5 * width;
  SignedDistance::Sample sample = shape(place);
  if (sample.distance >= larger) return dent;
  double way = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double slope = sample.outwards.dot(inwards);
    way -= (sample.distance - larger) / (slope > kLeastSlope ? slope : 1);
    if (way > deepest + larger) break;
    sample = shape(place + way * inwards);
  }
  if (way > deepest + larger) return {deepest, inwards, 1};
  dent.outwards = sample.outwards;
  dent.depth = std::min(deepest, way * std::max(0.0, sample.outwards.dot(inwards)) - larger);
  if (dent.depth <= 0) return Dent{};
  const double within = larger - shape(place + (way - width) * inwards).distance;
  dent.share = std::clamp(within / width, 0.0, 1.0);
  return dent;
}

}  // namespace resect
