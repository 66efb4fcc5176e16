#include "inventor/gl/triangle_blocks.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "geometry/primitives.h"

using namespace resect;

namespace {

struct Ball {
  std::vector<Vec3f> points;
  std::vector<Triangle> triangles;
  TriangleBlocks blocks;

  Ball() {
    const TriangleMesh mesh = sphereMesh(Vec3::Zero(), 1.0, 60);
    for (const Vec3& p : mesh.points) points.push_back(p.cast<float>());
    triangles = mesh.triangles;
    blocks.verticesChanged(0, points.size());
    blocks.trianglesChanged(0, triangles.size());
    blocks.refresh(points, triangles);
  }
  std::vector<std::uint8_t> taken(const TriangleBlocks::HalfSpaces& spaces) const {
    return inRuns(blocks.within(spaces));
  }
  // 1 for those in the runs.
  std::vector<std::uint8_t> inRuns(const std::vector<TriangleBlocks::Run>& runs) const {
    std::vector<std::uint8_t> taken(triangles.size());
    for (const TriangleBlocks::Run& run : runs)
      for (std::size_t t = run.first; t < std::min(run.first + run.count, triangles.size()); ++t)
        taken[t] = 1;
    return taken;
  }
};

// Everywhere, but for what the caller sets.
TriangleBlocks::HalfSpaces everywhere() {
  TriangleBlocks::HalfSpaces spaces;
  spaces.fill({0, 0, 0, 1});
  return spaces;
}

}  // namespace

TEST_CASE("no triangle with a corner in all half spaces is left out, and most others are") {
  const Ball ball;
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    TriangleBlocks::HalfSpaces spaces = everywhere();
    for (int s = 0; s < 3; ++s)
      spaces[std::size_t(s)] =
          Eigen::Vector4f(float(random.uniform(-1, 1)), float(random.uniform(-1, 1)),
                          float(random.uniform(-1, 1)), float(random.uniform(-1, 1)));
    const auto taken = ball.taken(spaces);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t)
      for (const std::int32_t v : ball.triangles[t]) {
        const bool inside = std::ranges::all_of(spaces, [&](const Eigen::Vector4f& s) {
          return ball.points[std::size_t(v)].dot(s.head<3>()) + s[3] >= 0;
        });
        if (inside) REQUIRE(taken[t]);
      }
  }
  // A cap of 2.5 % of the ball, at the side where triangles that follow each other lie together.
  std::ptrdiff_t least = std::ptrdiff_t(ball.triangles.size());
  for (int axis = 0; axis < 3; ++axis) {
    TriangleBlocks::HalfSpaces cap = everywhere();
    cap[0] = {0, 0, 0, -0.95f};
    cap[0][axis] = 1;
    least = std::min(least, std::ranges::count(ball.taken(cap), 1));
  }
  CHECK(least < std::ptrdiff_t(ball.triangles.size() / 8));
}

TEST_CASE("no triangle that a ray meets is left out, and most others are") {
  const Ball ball;
  Random random(9);
  const auto corner = [&](std::int32_t v) {
    return Vec3(ball.points[std::size_t(v)].cast<double>());
  };
  int met = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const auto any = [&](double most) {
      return Vec3(random.uniform(-most, most), random.uniform(-most, most),
                  random.uniform(-most, most));
    };
    Ray ray{any(2), any(1)};
    ray.direction = any(0.8) - ray.origin;
    const auto taken = ball.inRuns(ball.blocks.along(ray));
    for (std::size_t i = 0; i < ball.triangles.size(); ++i) {
      const Triangle& t = ball.triangles[i];
      if (std::isinf(firstMeeting(ray, corner(t[0]), corner(t[1]), corner(t[2])))) continue;
      REQUIRE(taken[i]);
      ++met;
    }
  }
  CHECK(met > 40);
  // Through the middle; strips of triangles reach round the ball, an organ's bricks are compact.
  std::ptrdiff_t least = std::ptrdiff_t(ball.triangles.size());
  for (int axis = 0; axis < 3; ++axis) {
    const Ray ray{2.0 * Vec3::Unit(axis) + Vec3::Constant(0.01), -Vec3::Unit(axis)};
    least = std::min(least, std::ranges::count(ball.inRuns(ball.blocks.along(ray)), 1));
  }
  CHECK(least < std::ptrdiff_t(ball.triangles.size() / 3));
}

TEST_CASE("what moved is found where it is now, and holes fill nothing") {
  Ball ball;
  TriangleBlocks::HalfSpaces far = everywhere();
  far[0] = {1, 0, 0, -4};
  CHECK(ball.blocks.within(far).empty());
  for (std::size_t v = 100; v < 200; ++v) ball.points[v].x() += 5;
  ball.blocks.verticesChanged(100, 200);
  ball.blocks.refresh(ball.points, ball.triangles);
  CHECK(!ball.blocks.within(far).empty());
  CHECK(ball.blocks.box().high.x() > 4.0f);
  std::ranges::fill(ball.triangles, Triangle{0, 0, 0});
  ball.blocks.trianglesChanged(0, ball.triangles.size());
  ball.blocks.refresh(ball.points, ball.triangles);
  CHECK(ball.blocks.box().empty());
  CHECK(ball.blocks.within(everywhere()).empty());
}

TEST_CASE("a part of the picture is cut out by the half spaces of its matrix") {
  const float flat[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const auto spaces = halfSpacesOf(flat, {0.0f, -0.5f}, {0.5f, 1.0f});
  const auto inside = [&](float x, float y, float z) {
    return std::ranges::all_of(
        spaces, [&](const Eigen::Vector4f& s) { return s.dot(Eigen::Vector4f(x, y, z, 1)) >= 0; });
  };
  CHECK(inside(0.25f, 0.0f, 0.5f));
  CHECK_FALSE(inside(-0.1f, 0.0f, 0.5f));
  CHECK_FALSE(inside(0.6f, 0.0f, 0.5f));
  CHECK_FALSE(inside(0.25f, -0.6f, 0.5f));
  CHECK_FALSE(inside(0.25f, 0.0f, 1.5f));
}
