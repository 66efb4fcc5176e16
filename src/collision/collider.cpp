#include "collision/collider.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace resect {

ColumnGrid pixelsOver(const Aabb& box, int resolution) {
  require(resolution >= 1, "a raster of {} pixels was asked for; give 1 or more", resolution);
  require(box.size().allFinite(), "there is no raster over an endless box; give a finite one");
  ColumnGrid pixels;
  if (!(box.size().array() > 0).all()) return pixels;
  const Vec2 size = box.size().head<2>();
  const auto along = [&](double side) {
    return std::clamp(int(std::lround(resolution * side / size.maxCoeff())), 1, resolution);
  };
  pixels.countX = along(size.x());
  pixels.countY = along(size.y());
  pixels.pitch = size.cwiseQuotient(Vec2(pixels.countX, pixels.countY));
  pixels.origin = box.min.head<2>() + 0.5 * pixels.pitch;
  return pixels;
}

LayeredDepthImage layeredDepthImage(const TriangleMesh& mesh, const Aabb& box,
                                    const ColumnGrid& pixels,
                                    std::span<const std::uint8_t> wanted) {
  require(wanted.empty() || wanted.size() == pixels.count(),
          "{} flags were given for {} pixels; give one for each, or none", wanted.size(),
          pixels.count());
  LayeredDepthImage image;
  image.pixels = pixels;
  image.offsets.reserve(pixels.count() + 1);
  const Crossings columns = castColumns(snapToRaster(mesh), pixels);
  for (std::size_t c = 0; c < pixels.count(); ++c) {
    if (wanted.empty() || wanted[c]) {
      int balance = 0;
      for (const Crossing& crossing : columns[c]) balance += crossing.sign;
      image.openPixels += balance != 0;
      forEachInside(columns[c], [&](double entered, double left) {
        const DepthInterval clipped{std::max(entered, box.min.z()), std::min(left, box.max.z())};
        if (clipped.entry < clipped.exit) image.intervals.push_back(clipped);
      });
    }
    image.offsets.push_back(std::uint32_t(image.intervals.size()));
  }
  return image;
}

std::vector<std::uint8_t> coveredPixels(const LayeredDepthImage& image) {
  std::vector<std::uint8_t> covered(image.pixels.count());
  for (std::size_t c = 0; c < covered.size(); ++c) covered[c] = !image[c].empty();
  return covered;
}

LayeredDepthImage intersectionVolume(const LayeredDepthImage& a, const LayeredDepthImage& b) {
  require(a.pixels.countX == b.pixels.countX && a.pixels.countY == b.pixels.countY,
          "images of {} x {} and {} x {} pixels have no common part; make both in the same pixels",
          a.pixels.countX, a.pixels.countY, b.pixels.countX, b.pixels.countY);
  LayeredDepthImage image;
  image.pixels = a.pixels;
  image.offsets.reserve(a.pixels.count() + 1);
  for (std::size_t c = 0; c < a.pixels.count(); ++c) {
    const auto first = a[c], second = b[c];
    for (std::size_t m = 0, n = 0; m < first.size() && n < second.size();) {
      const DepthInterval common{std::max(first[m].entry, second[n].entry),
                                 std::min(first[m].exit, second[n].exit)};
      if (common.entry < common.exit) image.intervals.push_back(common);
      // The interval that ends first has no further overlap.
      first[m].exit < second[n].exit ? ++m : ++n;
    }
    image.offsets.push_back(std::uint32_t(image.intervals.size()));
  }
  return image;
}

double volume(const LayeredDepthImage& image) {
  double length = 0;
  for (const DepthInterval& interval : image.intervals) length += interval.exit - interval.entry;
  return length * image.pixels.pitch.prod();
}

}  // namespace resect
