// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "collision/collider.h"
#include "collision/inside.h"
#include "collision/signed_distance.h"
#include "collision/swept_blade.h"
#include "geometry/primitives.h"
#include "support/sentence.h"

using namespace resect;
using test::refuses;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();
const Aabb kBox{Vec3::Zero(), Vec3::Ones()};

TriangleMesh withPoint(const Vec3& p) {
  TriangleMesh mesh = boxMesh(kBox);
  mesh.points[2] = p;
  return mesh;
}
TriangleMesh withIndex(std::int32_t index) {
  TriangleMesh mesh = boxMesh(kBox);
  mesh.triangles[2][0] = index;
  return mesh;
}

}  // namespace

TEST_CASE("pixels that are none, and flags and images that do not fit them, are refused") {
  CHECK(refuses([] { pixelsOver(kBox, 0); }, "0 pixels"));
  CHECK(refuses([] { pixelsOver({Vec3::Zero(), Vec3::Constant(kEndless)}, 8); }, "endless"));
  CHECK(pixelsOver({}, 8).count() == 0);
  const TriangleMesh mesh = boxMesh(kBox);
  const ColumnGrid pixels = pixelsOver(kBox, 4), others = pixelsOver(kBox, 5);
  const std::vector<std::uint8_t> flags(others.count(), 1);
  CHECK(refuses([&] { layeredDepthImage(mesh, kBox, pixels, flags); }, "25 flags"));
  const auto a = layeredDepthImage(mesh, kBox, pixels), b = layeredDepthImage(mesh, kBox, others);
  CHECK(refuses([&] { intersectionVolume(a, b); }, "same pixels"));
}

TEST_CASE("columns that stand nowhere, and meshes that are none, are refused") {
  const TriangleMesh mesh = boxMesh(kBox);
  const SnappedMesh snapped = snapToRaster(mesh);
  for (const ColumnGrid& grid :
       {ColumnGrid{Vec2::Zero(), Vec2::Ones(), -1, 2}, ColumnGrid{Vec2::Zero(), {0, 1}, 2, 2},
        ColumnGrid{Vec2::Zero(), {kNaN, 1}, 2, 2}, ColumnGrid{{kNaN, 0}, Vec2::Ones(), 2, 2}})
    CHECK(refuses([&] { castColumns(snapped, grid); }, "a grid of"));
  const std::vector<Vec3> points = {Vec3::Constant(0.5)};
  for (const TriangleMesh& wrong :
       {withPoint({kNaN, 0, 0}), withPoint({0, 0, kEndless}), withIndex(-1), withIndex(8)}) {
    CHECK(refuses([&] { snapToRaster(wrong); }, "of the mesh"));
    CHECK(refuses([&] { insideFlags(wrong, points); }, "of the mesh"));
    CHECK(refuses([&] { sweptInside(wrong, {}, {}, points); }, "of the mesh"));
    CHECK(refuses([&] { SignedDistance(wrong, 0.1, 0.1); }, "of the mesh"));
  }
  Pose nowhere;
  nowhere.position.x() = kNaN;
  CHECK(refuses([&] { sweptInside(mesh, {}, nowhere, points); }, "not a number"));
}

TEST_CASE("distances in cells that are none are refused; an empty mesh is far from everything") {
  for (const double wrong : {0.0, -1.0, kNaN, kEndless}) {
    CHECK(refuses([&] { SignedDistance(boxMesh(kBox), wrong, 0.1); }, "lengths above 0"));
    CHECK(refuses([&] { SignedDistance(boxMesh(kBox), 0.1, wrong); }, "lengths above 0"));
  }
  CHECK(SignedDistance({}, 0.1, 0.1)(Vec3::Zero()).distance == SignedDistance::kFar);
}

TEST_CASE("a blade's edges of different lengths, and strips of no flatness, are refused") {
  const std::vector<Vec3> two = {Vec3::Zero(), Vec3::UnitX()}, one = {Vec3::Zero()};
  CHECK(refuses([&] { ruledBlade(two, one); }, "2 points before and 1 after"));
  for (const double wrong : {0.0, -1.0, kNaN})
    CHECK(refuses([&] { sweepBlade(two, {}, {}, wrong); }, "flatness"));
}
