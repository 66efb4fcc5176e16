// What viewers draw of an instrument: every part of its file, jaws closed.
#include "io/drawn_parts.h"

#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/rotation.h"
#include "support/sentence.h"

using namespace resect;

namespace {

const Jaws kJaws{{0, 0, 0.05}, Vec3::UnitX(), 0.5};
const TriangleMesh kBoxMesh = boxMesh({{-0.01, 0, 0}, {0.01, 0.005, 0.05}});

TriangleMesh turned(TriangleMesh mesh, double angle) {
  const Eigen::Quaterniond turn = rotationAbout(kJaws.axis, angle);
  for (Vec3& p : mesh.points) p = kJaws.pivot + turn * (p - kJaws.pivot);
  return mesh;
}

std::vector<DrawnPart> drawn(std::vector<ModelPart> parts, const Jaws& jaws = kJaws) {
  return drawnParts({"own.obj", "OBJ", std::move(parts)}, jaws);
}

double farthest(const TriangleMesh& a, const TriangleMesh& b) {
  REQUIRE(a.points.size() == b.points.size());
  double most = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    most = std::max(most, (a.points[i] - b.points[i]).norm());
  return most;
}

}  // namespace

TEST_CASE("open jaws are kept closed, with the angle that opens them, and other parts stay") {
  const auto parts = drawn({{"JawUpper", turned(kBoxMesh, 0.25)},
                            {"JawLower_1", turned(kBoxMesh, -0.25)},
                            {"Handle", kBoxMesh}});
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].opens == doctest::Approx(0.25));
  CHECK(parts[1].opens == doctest::Approx(-0.25));
  CHECK(parts[2].opens == 0);
  for (const DrawnPart& part : parts) {
    CHECK(farthest(part.mesh, kBoxMesh) < 1e-15);
    CHECK(part.closed);
  }
}

TEST_CASE(
    "without an opening a part is no jaw, whatever its name; with one, a third jaw is refused") {
  CHECK(drawn({{"JawUpper", kBoxMesh}}, Jaws())[0].opens == 0);
  CHECK(drawn({{"Jawbone", kBoxMesh}}, Jaws())[0].opens == 0);
  CHECK(test::refuses([] { drawn({{"Jawbone", kBoxMesh}}); }, "'Jawbone'"));
}

TEST_CASE(
    "normals of a file stay with its points and turn with a jaw; a part that lacks one has none") {
  ModelPart part{"JawUpper", turned(kBoxMesh, 0.25)};
  part.mesh.triangles.push_back(part.mesh.triangles[0]);  // welding would not change the points
  const Vec3f up = (rotationAbout(kJaws.axis, 0.25) * Vec3::UnitY()).cast<float>();
  part.normals.assign(part.mesh.points.size(), up);
  const auto turnedBack = drawn({part});
  REQUIRE(turnedBack[0].normals.size() == turnedBack[0].mesh.points.size());
  for (const Vec3f& n : turnedBack[0].normals) CHECK((n - Vec3f::UnitY()).norm() < 1e-6f);
  part.normals[3].setZero();
  CHECK(drawn({part})[0].normals.empty());
}

TEST_CASE("points that a format repeats become one, so that normals can be smooth") {
  TriangleMesh soup;
  for (const Triangle& t : kBoxMesh.triangles) {
    const auto n = std::int32_t(soup.points.size());
    for (const std::int32_t v : t) soup.points.push_back(kBoxMesh.points[std::size_t(v)]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  CHECK(drawn({{"", soup}})[0].mesh.points.size() == kBoxMesh.points.size());
}

TEST_CASE("a closed part that is inside out is turned, an open one is drawn as it is") {
  TriangleMesh inside = kBoxMesh;
  flip(inside);
  const auto parts = drawn({{"a", inside}});
  CHECK(volume(parts[0].mesh) > 0);
  CHECK(parts[0].closed);
  TriangleMesh open = kBoxMesh;
  open.triangles.pop_back();
  CHECK_FALSE(drawn({{"a", open}})[0].closed);
}

TEST_CASE("a part of needles without any area left is not drawn") {
  const TriangleMesh point{{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {{0, 1, 2}}};
  CHECK(drawn({{"a", point}, {"b", kBoxMesh}}).size() == 1);
}
