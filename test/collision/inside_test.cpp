#include "collision/inside.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/parallel.h"
#include "base/random.h"
#include "geometry/primitives.h"
#include "support/references/mesh_reference.h"

using namespace resect;
using Flags = std::vector<std::uint8_t>;

namespace {

std::vector<Vec3> randomPoints(int count, const Aabb& box, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    Vec3 p;
    for (int a = 0; a < 3; ++a) p[a] = random.uniform(box.min[a], box.max[a]);
    points.push_back(p);
  }
  return points;
}

Eigen::Quaterniond turnBy(double degrees, const Vec3& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()));
}

// A blade: 2 cm x 6 cm and a tenth of a millimetre thick, wedge-shaped.
TriangleMesh blade() {
  TriangleMesh mesh = boxMesh({{-0.01, -0.03, -0.00005}, {0.01, 0.03, 0.00005}});
  for (Vec3& p : mesh.points)
    if (p.x() > 0) p.z() *= 0.02;
  return mesh;
}

// Touched at any of the poses 0, 1/n, ..., 1 of the motion.
Flags denselySampled(const TriangleMesh& tool, const Pose& from, const Pose& to, int poses,
                     const std::vector<Vec3>& points) {
  Flags touched(points.size(), 0);
  for (int i = 0; i <= poses; ++i) {
    const Pose back = interpolate(from, to, double(i) / poses).inverse();
    std::vector<Vec3> local;
    for (const Vec3& p : points) local.push_back(back * p);
    const Flags inside = insideFlags(tool, local);
    for (std::size_t n = 0; n < points.size(); ++n) touched[n] |= inside[n];
  }
  return touched;
}

// Distance of the point to the tool's path at those poses, 0 inside.
double distanceToPath(const TriangleMesh& tool, const Pose& from, const Pose& to, int poses,
                      const Vec3& point) {
  double least = 1e9;
  for (int i = 0; i <= poses; ++i)
    least = std::min(least, test::distanceToMesh(
                                tool, interpolate(from, to, double(i) / poses).inverse() * point));
  return least;
}

int count(const Flags& flags) {
  int sum = 0;
  for (const auto flag : flags) sum += flag;
  return sum;
}

}  // namespace

TEST_CASE("inside flags equal the solid angle's answer") {
  const TriangleMesh mesh =
      transformed(torusMesh({0, 0, 0}, 0.05, 0.02), {{0.3, 0.2, 0.1}, turnBy(40, {1, 2, 3})});
  const auto points = randomPoints(2000, bounds(mesh).padded(0.01), 1);
  const Flags inside = insideFlags(mesh, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(bool(inside[i]) == (test::solidAngleWinding(mesh, points[i]) > 0.5));
  CHECK(count(inside) > 200);
  CHECK(insideFlags({}, points) == Flags(points.size(), 0));
  CHECK(insideFlags(mesh, {}).empty());
}

TEST_CASE("two boxes that share a face share no point and lose none on it") {
  const TriangleMesh low = boxMesh({{0, 0, 0}, {1, 1, 1}}), high = boxMesh({{0, 0, 1}, {1, 1, 2}}),
                     right = boxMesh({{1, 0, 0}, {2, 1, 1}});
  const std::vector<Vec3> onZ{{0.25, 0.5, 1}}, onX{{1, 0.5, 0.5}};
  CHECK(insideFlags(low, onZ)[0] + insideFlags(high, onZ)[0] == 1);
  CHECK(insideFlags(low, onX)[0] + insideFlags(right, onX)[0] == 1);
}

TEST_CASE("a jumping blade skips nothing: pure translation equals the dense sampling") {
  // Broadside, along its length, edge first, oblique, and jumps far beyond its own thickness.
  const Pose from{{0.02, -0.01, 0.03}, turnBy(25, {1, 0.3, 0.2})};
  for (const Vec3& way : {Vec3(0, 0, 0.08), Vec3(0.05, 0, 0), Vec3(0.001, 0.06, 0.002),
                          Vec3(0.03, 0.04, -0.05), Vec3(-0.0002, 0, 0.0001)}) {
    const Pose to{from.position + way, from.rotation};
    const TriangleMesh tool = blade();
    Aabb box = bounds(transformed(tool, from));
    box.grow(bounds(transformed(tool, to)));
    const auto points = randomPoints(1500, box, 11);
    const Flags ours = sweptInside(tool, from, to, points);
    const Flags reference = denselySampled(tool, from, to, 2000, points);
    int beyond = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      // What the samples see, we see.
      CHECK(ours[i] >= reference[i]);
      if (ours[i] == reference[i]) continue;
      // What only we see lies between two samples: within half a sample's way of the tool.
      ++beyond;
      CHECK(distanceToPath(tool, from, to, 2000, points[i]) <= 0.5 * way.norm() / 2000 + 1e-9);
    }
    CHECK(count(ours) > 10);
    CHECK(beyond < count(ours));
  }
}

TEST_CASE("a translated box touches exactly the box of its path") {
  const TriangleMesh tool = boxMesh({{-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01}});
  const auto points = randomPoints(5000, {{-0.03, -0.03, -0.03}, {0.13, 0.03, 0.03}}, 2);
  const Flags ours = sweptInside(tool, {}, {{0.1, 0, 0}, Eigen::Quaterniond::Identity()}, points);
  const Aabb path{{-0.01, -0.01, -0.01}, {0.11, 0.01, 0.01}};
  for (std::size_t i = 0; i < points.size(); ++i) CHECK(bool(ours[i]) == path.contains(points[i]));
}

TEST_CASE("a turning tool touches what the dense sampling touches, within a shell") {
  const TriangleMesh tool = transformed(blade(), {{0.05, 0, 0}, Eigen::Quaterniond::Identity()});
  const Pose from{{0.02, -0.01, 0.03}, turnBy(25, {1, 0.3, 0.2})};
  const Pose tos[] = {{from.position, turnBy(30, {0, 1, 0}) * from.rotation},
                      {from.position + Vec3(0.05, 0.02, 0), turnBy(100, {1, 1, 0}) * from.rotation},
                      {from.position + Vec3(0.3, 0, 0), turnBy(0.5, {0, 0, 1}) * from.rotation},
                      {from.position, turnBy(179, {0.1, 1, 0}) * from.rotation}};
  for (const Pose& to : tos) {
    Aabb box;
    for (int i = 0; i <= 20; ++i)
      box.grow(bounds(transformed(tool, interpolate(from, to, i / 20.0))));
    const auto points = randomPoints(1200, box, 5);
    const Flags ours = sweptInside(tool, from, to, points);
    const Flags reference = denselySampled(tool, from, to, 2000, points);
    // The path is taken as chords: up to 1e-4 of the tool's diagonal beside it; and the samples
    // stand up to 0.3 mm apart.
    const double shell = 1e-4 * bounds(tool).size().norm() + 0.3 / 2000 + 0.1 * M_PI / 2000;
    int differing = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (ours[i] == reference[i]) continue;
      ++differing;
      CHECK(distanceToPath(tool, from, to, 2000, points[i]) <= shell);
    }
    CHECK(count(ours) > 25);
    CHECK(differing < count(ours));
    // Whatever is inside at either end is contained, exactly.
    for (const Pose& pose : {from, to}) {
      const Pose back = pose.inverse();
      std::vector<Vec3> local;
      for (const Vec3& p : points) local.push_back(back * p);
      const Flags inside = insideFlags(tool, local);
      for (std::size_t i = 0; i < points.size(); ++i) CHECK(ours[i] >= inside[i]);
    }
  }
}

TEST_CASE(
    "a plate a thousandth of a millimetre thick misses no point of the sector it turns through") {
  // Along x from 2 to 10 cm, turned round y by 100 degrees: x towards -z.
  const TriangleMesh plate = boxMesh({{0.02, -0.03, -5e-7}, {0.1, 0.03, 5e-7}});
  const double turn = 100 * M_PI / 180;
  const auto points = randomPoints(20000, {{-0.1, -0.04, -0.12}, {0.12, 0.04, 0.02}}, 8);
  const Flags ours = sweptInside(plate, {}, {Vec3::Zero(), turnBy(100, {0, 1, 0})}, points);
  const double margin = 1e-4 * bounds(plate).size().norm() + 1e-6;
  int within = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    const double r = std::hypot(p.x(), p.z()), angle = std::atan2(-p.z(), p.x());
    // How far inside the sector the point lies; negative outside.
    const double depth =
        std::min({r - 0.02, 0.1 - r, 0.03 - std::abs(p.y()), r * angle, r * (turn - angle)});
    if (std::abs(depth) < margin) continue;
    CHECK(bool(ours[i]) == (depth > 0));
    within += depth > 0;
  }
  CHECK(within > 4000);
}

TEST_CASE("a tool that stands still touches what is inside it") {
  const TriangleMesh tool = sphereMesh({0, 0, 0}, 0.02, 8);
  const Pose pose{{0.1, 0.2, 0.3}, turnBy(70, {1, 2, 0})};
  const auto points = randomPoints(2000, bounds(transformed(tool, pose)), 3);
  std::vector<Vec3> local;
  for (const Vec3& p : points) local.push_back(pose.inverse() * p);
  CHECK(sweptInside(tool, pose, pose, points) == insideFlags(tool, local));
  CHECK(sweptInside({}, pose, pose, points) == Flags(points.size(), 0));
  CHECK(sweptInside(tool, pose, pose, {}).empty());
}

TEST_CASE("swept flags are the same at 1, 2 and 3 threads") {
  const TriangleMesh tool = torusMesh({0, 0, 0}, 0.03, 0.01);
  const Pose from{}, to{{0.05, 0.01, 0}, turnBy(45, {1, 1, 1})};
  const auto points = randomPoints(8000, {{-0.05, -0.05, -0.05}, {0.1, 0.06, 0.05}}, 9);
  const auto swept = [&](int threads) {
    const ThreadLimit limit(threads);
    return std::pair(sweptInside(tool, from, to, points),
                     sweptInside(tool, from, {to.position, from.rotation}, points));
  };
  const auto one = swept(1);
  CHECK(swept(2) == one);
  CHECK(swept(3) == one);
}
