#include "organ/picture/picture_vessels.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace resect;

namespace {

double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  return (a + std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0) * way - p).norm();
}

// How far the place is outside the nearest wall, m; below 0 in a wall or lumen; as
// data/shaders/vessels.glsl finds it.
double offByPicture(const VesselPicture& picture, const Vec3& place) {
  const Vec3 at = (place - picture.low.cast<double>()) / picture.bin;
  Vec3i cell;
  for (int a = 0; a < 3; ++a) cell[a] = int(std::floor(at[a]));
  double least = 1;
  if ((cell.array() < 0).any() || (cell.array() >= picture.dims.array()).any()) return least;
  const auto [first, count] = picture.bins[std::size_t(
      (cell.z() * picture.dims.y() + cell.y()) * picture.dims.x() + cell.x())];
  for (int i = 0; i < int(count); ++i) {
    const auto& e = picture.entries[std::size_t(first) + std::size_t(i)];
    const double off = distance(place, {e[0], e[1], e[2]}, {e[4], e[5], e[6]}) - e[3];
    least = std::min(least, off - wallOf(VesselKind(int(e[7])), e[3]));
  }
  return least;
}

}  // namespace

TEST_CASE("the picture has every vessel at every place in its lumen or wall, and no other") {
  Random random(5);
  std::vector<VesselSegment> segments;
  for (int i = 0; i < 200; ++i) {
    const auto place = [&] {
      return Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.05, 0.08),
                  random.uniform(-0.1, 0.1));
    };
    const Vec3 start = place();
    segments.push_back({VesselKind(i / 50), -1, start, start + 0.3 * (place() - start),
                        random.uniform(0.0003, 0.006), true});
  }
  const Anatomy anatomy = makeAnatomy(segments);
  const auto picture = pictureVessels(anatomy);
  REQUIRE(picture);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const VesselSegment& s = anatomy.segments[std::size_t(random.below(200))];
    const double spread = 1.5 * s.radius;
    const Vec3 place = s.at(random.uniform(0, 1)) + Vec3(random.uniform(-spread, spread),
                                                         random.uniform(-spread, spread),
                                                         random.uniform(-spread, spread));
    double off = 1;
    for (const VesselSegment& v : anatomy.segments)
      off = std::min(off, distance(place, v.start, v.end) - v.radius - wallOf(v.kind, v.radius));
    if (off >= 0) continue;
    ++seen;
    CHECK(offByPicture(*picture, place) == doctest::Approx(off).epsilon(1e-3).scale(1e-3));
  }
  CHECK(seen > 5000);
  CHECK_FALSE(pictureVessels(Anatomy()));
}
