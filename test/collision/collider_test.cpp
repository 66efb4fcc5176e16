#include "collision/collider.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/random.h"
#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"

using namespace resect;

namespace {

struct Collision {
  Aabb common;
  LayeredDepthImage first, second, both;
};

Collision collide(const TriangleMesh& a, const TriangleMesh& b, int resolution) {
  Collision c;
  c.common = intersection(bounds(a), bounds(b));
  const ColumnGrid pixels = pixelsOver(c.common, resolution);
  c.first = layeredDepthImage(a, c.common, pixels);
  c.second = layeredDepthImage(b, c.common, pixels);
  c.both = intersectionVolume(c.first, c.second);
  return c;
}

std::size_t most(const LayeredDepthImage& image) {
  std::size_t most = 0;
  for (std::size_t c = 0; c < image.pixels.count(); ++c) most = std::max(most, image[c].size());
  return most;
}

TriangleMesh tilted(const TriangleMesh& mesh, const Vec3& to) {
  return transformed(mesh, {to, Eigen::Quaterniond(0.8, 0.3, 0.1, -0.4).normalized()});
}

}  // namespace

TEST_CASE("two boxes share exactly the box of their overlap at any resolution") {
  const TriangleMesh a = boxMesh({{0, 0, 0}, {4, 3, 2}}), b = boxMesh({{3, 1, -1}, {6, 2, 0.5}});
  for (const int resolution : {1, 3, 64}) {
    const Collision c = collide(a, b, resolution);
    CHECK(c.common.min == Vec3(3, 1, 0));
    CHECK(c.common.max == Vec3(4, 2, 0.5));
    CHECK(most(c.both) == 1);
    CHECK(c.both.pixels.countX == resolution);
    CHECK(volume(c.both) == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(c.both[0][0].entry == 0);
    CHECK(c.both[0][0].exit == 0.5);
  }
}

TEST_CASE("points of a pixel's column are in its stretches where both meshes hold them") {
  const TriangleMesh organ = tilted(torusMesh({0, 0, 0}, 0.08, 0.03), {0.1, 0, 0});
  const TriangleMesh blade =
      tilted(boxMesh({{0, -0.02, 0.0101}, {0.2, 0.02, 0.0105}}), {0.1, 0, 0});
  const TriangleMesh ball = sphereMesh({0.15, 0.05, 0}, 0.06, 10);
  Random random(4);
  for (const TriangleMesh& tool : {blade, ball})
    for (const int resolution : {1, 7, 64}) {
      const Collision c = collide(organ, tool, resolution);
      std::vector<Vec3> points;
      std::vector<bool> expected;
      for (int j = 0; j < c.both.pixels.countY; ++j)
        for (int i = 0; i < c.both.pixels.countX; ++i)
          for (int k = 0; k < 20; ++k) {
            const Vec2 at = c.both.pixels.origin + c.both.pixels.pitch.cwiseProduct(Vec2(i, j));
            const double z = random.uniform(c.common.min.z(), c.common.max.z());
            points.emplace_back(at.x(), at.y(), z);
            bool inside = false;
            for (const DepthInterval& s : c.both[std::size_t(j * c.both.pixels.countX + i)])
              inside = inside || (s.entry < z && z <= s.exit);
            expected.push_back(inside);
          }
      const auto inOrgan = insideFlags(organ, points), inTool = insideFlags(tool, points);
      int both = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        both += inOrgan[i] && inTool[i];
        REQUIRE(expected[i] == (inOrgan[i] && inTool[i]));
      }
      if (resolution == 64) CHECK(both > 3);
    }
}

TEST_CASE("the overlap of two balls converges to the lens between them") {
  const double r = 1, apart = 1.2;
  const double lens = std::numbers::pi * std::pow(2 * r - apart, 2) *
                      (apart * apart + 4 * r * apart) / (12 * apart);
  const TriangleMesh a = tilted(sphereMesh({0, 0, 0}, r, 120), {0.3, 0.2, 0.1});
  const TriangleMesh b =
      tilted(sphereMesh({0, 0, 0}, r, 120), Vec3(0.3, 0.2, 0.1) + apart * Vec3(2, -1, 2) / 3);
  for (const int n : {16, 64, 256})
    // The balls' own facets cost less than 1e-3.
    CHECK(std::abs(volume(collide(a, b, n).both) / lens - 1) < 1e-3 + 2 * std::pow(n, -1.5));
}

TEST_CASE("a body inside the other shares its whole volume, whichever comes first") {
  const TriangleMesh organ = sphereMesh({0, 0, 0}, 0.1, 24);
  const TriangleMesh tool = tilted(boxMesh({{-0.02, -0.01, -0.03}, {0.02, 0.01, 0.03}}), {0, 0, 0});
  const Collision ab = collide(organ, tool, 128), ba = collide(tool, organ, 128);
  CHECK(volume(ab.both) == volume(ba.both));
  CHECK(volume(ab.both) == volume(ab.second));
  CHECK(volume(ab.second) == doctest::Approx(volume(tool)).epsilon(2e-3));
}

TEST_CASE("a part counts once in the volume however many shells cover it") {
  TriangleMesh doubled = boxMesh({{0, 0, 0}, {2, 2, 2}});
  append(doubled, boxMesh({{0, 0, 1}, {2, 2, 3}}));
  const Collision c = collide(doubled, boxMesh({{0, 0, 0}, {2, 2, 4}}), 8);
  CHECK(volume(c.both) == doctest::Approx(12));
  CHECK(most(c.first) == 1);
}

TEST_CASE("bodies whose boxes are apart or only touch have no pixels and share nothing") {
  const TriangleMesh a = boxMesh({{0, 0, 0}, {1, 1, 1}});
  for (const Vec3& at : {Vec3(3, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 1)}) {
    const Collision c = collide(a, boxMesh({at, at + Vec3(1, 1, 1)}), 16);
    CHECK(c.both.pixels.count() == 0);
    CHECK(volume(c.both) == 0);
  }
  // Boxes that meet around bodies that do not.
  const Collision apart = collide(sphereMesh({0, 0, 0}, 1), sphereMesh({1.3, 1.3, 1.3}, 1), 32);
  CHECK(most(apart.both) == 0);
  CHECK(volume(apart.both) == 0);
}

TEST_CASE("of a body only the pixels of the other are needed: the same common part") {
  const TriangleMesh organ = tilted(torusMesh({0, 0, 0}, 0.08, 0.03), {0.1, 0, 0});
  const TriangleMesh tool = sphereMesh({0.15, 0.05, 0}, 0.06, 10);
  const Collision c = collide(organ, tool, 40);
  const std::vector<std::uint8_t> covered = coveredPixels(c.second);
  const LayeredDepthImage some = layeredDepthImage(organ, c.common, c.both.pixels, covered);
  CHECK(some.intervals.size() < c.first.intervals.size());
  for (std::size_t p = 0; p < covered.size(); ++p)
    CHECK(some[p].size() == (covered[p] ? c.first[p].size() : 0));
  CHECK(volume(intersectionVolume(some, c.second)) == volume(c.both));
}

TEST_CASE("pixels in which a mesh is open are counted, where they are wanted") {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  TriangleMesh open = boxMesh(box);
  CHECK(layeredDepthImage(open, box, pixelsOver(box, 8)).openPixels == 0);
  open.triangles.erase(open.triangles.begin() + 8, open.triangles.begin() + 10);
  CHECK(layeredDepthImage(open, box, pixelsOver(box, 8)).openPixels == 64);
  const std::vector<std::uint8_t> none(64, 0);
  CHECK(layeredDepthImage(open, box, pixelsOver(box, 8), none).openPixels == 0);
}

TEST_CASE("depth images are the same bits at 1, 2 and 3 threads") {
  const TriangleMesh a = tilted(torusMesh({0, 0, 0}, 0.08, 0.03, 200, 100), {0.1, 0, 0});
  const TriangleMesh b = sphereMesh({0.15, 0.05, 0}, 0.06, 60);
  const auto lines = [&](int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> all;
    for (const DepthInterval& s : collide(a, b, 100).both.intervals)
      all.insert(all.end(), {s.entry, s.exit});
    return all;
  };
  const auto one = lines(1);
  CHECK(one.size() > 1000);
  CHECK(one == lines(2));
  CHECK(one == lines(3));
}
