#include "collision/collider.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "support/mesh_reference.h"

using namespace resect;

namespace {

Collider collided(const TriangleMesh& a, const TriangleMesh& b, int resolution) {
  Collider collider;
  collider.setObject(Collider::First, a);
  collider.setObject(Collider::Second, b);
  REQUIRE(collider.generateVolumeOfInterest());
  collider.generateLayeredDepthImages(resolution);
  collider.generateIntersectionVolume();
  return collider;
}

TriangleMesh tilted(const TriangleMesh& mesh, const Vec3& to) {
  return transformed(mesh, {to, Eigen::Quaterniond(0.8, 0.3, 0.1, -0.4).normalized()});
}

}  // namespace

TEST_CASE("two boxes share exactly the box of their overlap at any resolution") {
  const TriangleMesh a = boxMesh({{0, 0, 0}, {4, 3, 2}}), b = boxMesh({{3, 1, -1}, {6, 2, 0.5}});
  for (const int resolution : {1, 3, 64}) {
    const Collider collider = collided(a, b, resolution);
    CHECK(collider.volumeOfInterest().min == Vec3(3, 1, 0));
    CHECK(collider.volumeOfInterest().max == Vec3(4, 2, 0.5));
    const LayeredDepthImage& ldi = collider.ldi(Collider::Intersection);
    CHECK(ldi.depth() == 1);
    CHECK(ldi.columnsX() == resolution);
    CHECK(ldi.volume() == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(ldi.pixel(0, 0)[0].entry == 0);
    CHECK(ldi.pixel(0, 0)[0].exit == 0.5);
    CHECK(ldi.isInside({3.5, 1.5, 0.25}));
    CHECK_FALSE(ldi.isInside({3.5, 1.5, 0.75}));
    CHECK_FALSE(ldi.isInside({2.5, 1.5, 0.25}));
  }
}

TEST_CASE("isInside equals the exact inside test of both meshes, at every point and resolution") {
  const TriangleMesh organ = tilted(torusMesh({0, 0, 0}, 0.08, 0.03), {0.1, 0, 0});
  const TriangleMesh blade =
      tilted(boxMesh({{0, -0.02, 0.0101}, {0.2, 0.02, 0.0105}}), {0.1, 0, 0});
  const TriangleMesh ball = sphereMesh({0.15, 0.05, 0}, 0.06, 10);
  Random random(4);
  for (const TriangleMesh& tool : {blade, ball})
    for (const int resolution : {1, 7, 64}) {
      const Collider collider = collided(organ, tool, resolution);
      const Aabb box = collider.volumeOfInterest().padded(0.005);
      std::vector<Vec3> points;
      for (int i = 0; i < 3000; ++i)
        points.emplace_back(random.uniform(box.min.x(), box.max.x()),
                            random.uniform(box.min.y(), box.max.y()),
                            random.uniform(box.min.z(), box.max.z()));
      // Points within the tool's hull, for it may be thin.
      for (int i = 0; i < 1000; ++i) {
        Vec3 sum = Vec3::Zero();
        for (int n = 0; n < 4; ++n) sum += tool.points[random.below(int(tool.points.size()))];
        points.push_back(sum / 4);
      }
      // And points on the silhouettes and faces themselves.
      points.insert(points.end(), organ.points.begin(), organ.points.end());
      points.insert(points.end(), tool.points.begin(), tool.points.end());
      const auto inOrgan = insideFlags(organ, points), inTool = insideFlags(tool, points);
      const LayeredDepthImage& ldi = collider.ldi(Collider::Intersection);
      int both = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        both += inOrgan[i] && inTool[i];
        CHECK(ldi.isInside(points[i]) == (inOrgan[i] && inTool[i]));
        if (!collider.volumeOfInterest().contains(points[i])) continue;
        CHECK(collider.ldi(Collider::First).isInside(points[i]) == bool(inOrgan[i]));
        CHECK(collider.ldi(Collider::Second).isInside(points[i]) == bool(inTool[i]));
      }
      CHECK(both > 3);
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
    CHECK(std::abs(collided(a, b, n).ldi(Collider::Intersection).volume() / lens - 1) <
          1e-3 + 2 * std::pow(n, -1.5));
}

TEST_CASE("a body inside the other shares its whole volume, whichever comes first") {
  const TriangleMesh organ = sphereMesh({0, 0, 0}, 0.1, 24);
  const TriangleMesh tool = tilted(boxMesh({{-0.02, -0.01, -0.03}, {0.02, 0.01, 0.03}}), {0, 0, 0});
  const Collider ab = collided(organ, tool, 128), ba = collided(tool, organ, 128);
  CHECK(ab.ldi(Collider::Intersection).volume() == ba.ldi(Collider::Intersection).volume());
  CHECK(ab.ldi(Collider::Intersection).volume() == ab.ldi(Collider::Second).volume());
  CHECK(ab.ldi(Collider::Second).volume() == doctest::Approx(volume(tool)).epsilon(2e-3));
}

TEST_CASE("a part counts once in the volume however many shells cover it") {
  TriangleMesh doubled = boxMesh({{0, 0, 0}, {2, 2, 2}});
  append(doubled, boxMesh({{0, 0, 1}, {2, 2, 3}}));
  const Collider collider = collided(doubled, boxMesh({{0, 0, 0}, {2, 2, 4}}), 8);
  CHECK(collider.ldi(Collider::Intersection).volume() == doctest::Approx(12));
  CHECK(collider.ldi(Collider::First).depth() == 1);
}

TEST_CASE("bodies whose boxes are apart or only touch have no volume of interest") {
  const TriangleMesh a = boxMesh({{0, 0, 0}, {1, 1, 1}});
  for (const Vec3& at : {Vec3(3, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 1)}) {
    Collider collider;
    collider.setObject(Collider::First, a);
    collider.setObject(Collider::Second, boxMesh({at, at + Vec3(1, 1, 1)}));
    CHECK_FALSE(collider.generateVolumeOfInterest());
    collider.generateLayeredDepthImages(16);
    collider.generateIntersectionVolume();
    const LayeredDepthImage& ldi = collider.ldi(Collider::Intersection);
    CHECK(ldi.depth() == 0);
    CHECK(ldi.volume() == 0);
    CHECK_FALSE(ldi.isInside({0.5, 0.5, 0.5}));
  }
  // Boxes that meet around bodies that do not.
  const Collider apart = collided(sphereMesh({0, 0, 0}, 1), sphereMesh({1.3, 1.3, 1.3}, 1), 32);
  CHECK(apart.ldi(Collider::Intersection).depth() == 0);
  CHECK(apart.ldi(Collider::Intersection).volume() == 0);
}

TEST_CASE("the thesis's arrays of float vertices and faces are taken, boxes included") {
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 1, 10);
  std::vector<Vec3f> vertices;
  for (const Vec3& p : ball.points) vertices.push_back(p.cast<float>());
  Collider collider;
  collider.setObject(Collider::First, bounds(ball), vertices, ball.triangles);
  collider.setObject(Collider::Second, boxMesh({{0, -2, -2}, {2, 2, 2}}));
  REQUIRE(collider.generateVolumeOfInterest());
  collider.generateLayeredDepthImages(128);
  collider.generateIntersectionVolume();
  CHECK(collider.ldi(Collider::Intersection).volume() ==
        doctest::Approx(volume(ball) / 2).epsilon(2e-3));
  // Set anew, moved away: nothing is left of the old answer.
  collider.setObject(Collider::Second, boxMesh({{5, -2, -2}, {7, 2, 2}}));
  CHECK(collider.ldi(Collider::Intersection).depth() == 0);
  CHECK_FALSE(collider.generateVolumeOfInterest());
}

TEST_CASE("open meshes, wrong indices and wrong vertices are refused in a sentence") {
  TriangleMesh open = boxMesh({{0, 0, 0}, {1, 1, 1}});
  open.triangles.erase(open.triangles.begin() + 8, open.triangles.begin() + 10);
  Collider collider;
  collider.setObject(Collider::First, boxMesh({{0, 0, 0}, {1, 1, 1}}));
  collider.setObject(Collider::Second, open);
  REQUIRE(collider.generateVolumeOfInterest());
  CHECK_THROWS_WITH_AS(collider.generateLayeredDepthImages(8),
                       doctest::Contains("the second object is not closed"), Error);
  TriangleMesh wrong = boxMesh({{0, 0, 0}, {1, 1, 1}});
  wrong.triangles[3][1] = 8;
  CHECK_THROWS_AS(collider.setObject(Collider::First, wrong), Error);
  wrong.triangles[3][1] = -1;
  CHECK_THROWS_AS(collider.setObject(Collider::First, wrong), Error);
  wrong = boxMesh({{0, 0, 0}, {1, 1, 1}});
  wrong.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(collider.setObject(Collider::First, wrong), Error);
  CHECK_THROWS_AS(collider.generateLayeredDepthImages(0), Error);
}

TEST_CASE("depth images are the same bits at 1, 2 and 3 threads") {
  const TriangleMesh a = tilted(torusMesh({0, 0, 0}, 0.08, 0.03, 200, 100), {0.1, 0, 0});
  const TriangleMesh b = sphereMesh({0.15, 0.05, 0}, 0.06, 60);
  const auto lines = [&](int threads) {
    const ThreadLimit limit(threads);
    const Collider collider = collided(a, b, 100);
    const LayeredDepthImage& ldi = collider.ldi(Collider::Intersection);
    std::vector<double> all;
    for (int j = 0; j < ldi.columnsY(); ++j)
      for (int i = 0; i < ldi.columnsX(); ++i)
        for (const DepthInterval& s : ldi.pixel(i, j)) all.insert(all.end(), {s.entry, s.exit});
    return all;
  };
  const auto one = lines(1);
  CHECK(one.size() > 1000);
  CHECK(one == lines(2));
  CHECK(one == lines(3));
}
