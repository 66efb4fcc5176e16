#include "geometry/repair/shells.h"

#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/repair/repair.h"
#include "geometry/topology.h"

using namespace resect;

namespace {

TriangleMesh cubeOf(double side, double x = 0, bool inwards = false) {
  const Vec3 half = Vec3::Constant(side / 2), centre(x, 0, 0);
  TriangleMesh mesh = boxMesh({centre - half, centre + half});
  if (inwards) flip(mesh);
  return mesh;
}

TriangleMesh together(std::initializer_list<TriangleMesh> meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) append(all, mesh);
  return all;
}

}  // namespace

TEST_CASE("nested shells are bodies, cavities or within a body, as they face") {
  // A box in a cavity in a box that contains, elsewhere, a box that faces outwards; a box beside.
  const std::vector<Shell> shells = shellsOf(
      together({cubeOf(1, 2), cubeOf(10), cubeOf(4, -2, true), cubeOf(2, -2), cubeOf(3, 20)}));
  REQUIRE(shells.size() == 5);
  CHECK(shells[0].kind == ShellKind::Within);
  CHECK(shells[1].kind == ShellKind::Body);
  CHECK(shells[2].kind == ShellKind::Cavity);
  CHECK(shells[3].kind == ShellKind::Body);
  CHECK(shells[4].kind == ShellKind::Body);
  CHECK(shells[2].volume == doctest::Approx(64));
  CHECK(shells[2].box.centre().x() == doctest::Approx(-2));
  CHECK(tissueVolume(shells) == doctest::Approx(1000 - 64 + 8 + 27));
}

TEST_CASE("a cavity in a shell that faces outwards within a body is told by itself") {
  const std::vector<Shell> shells = shellsOf(together({cubeOf(10), cubeOf(6), cubeOf(2, 0, true)}));
  CHECK(shells[1].kind == ShellKind::Within);
  CHECK(shells[2].kind == ShellKind::Within);  // both sides are still inside the outermost
  CHECK(tissueVolume(shells) == doctest::Approx(1000));
}

TEST_CASE("shells whose boxes lie in each other are not nested for that") {
  // A small ball in the corner of the torus's box, and one in its hole.
  const TriangleMesh ring = torusMesh({0, 0, 0}, 1, 0.2);
  const std::vector<Shell> shells =
      shellsOf(together({ring, sphereMesh({1.1, 0, 1.1}, 0.05), sphereMesh({0, 0, 0}, 0.1, 8),
                         sphereMesh({1, 0, 0}, 0.1, 8)}));
  CHECK(shells[1].kind == ShellKind::Body);
  CHECK(shells[2].kind == ShellKind::Body);
  CHECK(shells[3].kind == ShellKind::Within);
}

TEST_CASE("a surface with each face twice becomes one with each face once") {
  TriangleMesh front = sphereMesh({0, 0, 0}, 1, 8), back = front;
  flip(back);
  RepairReport report;
  for (const TriangleMesh& second : {front, back}) {
    TriangleMesh both = front;
    both.triangles.insert(both.triangles.end(), second.triangles.begin(), second.triangles.end());
    report = {};
    dropDoubled(both, report);
    CHECK(both.triangles == front.triangles);
    CHECK(report.trianglesDoubled == int(front.triangles.size()));
  }
  // Face and back by turns, the back first for some.
  TriangleMesh turns = front;
  turns.triangles.clear();
  for (std::size_t t = 0; t < front.triangles.size(); ++t) {
    turns.triangles.push_back((t % 3 ? front : back).triangles[t]);
    turns.triangles.push_back((t % 3 ? back : front).triangles[t]);
  }
  dropDoubled(turns, report);
  orientConsistently(turns, report);
  turnOutwards(turns, report);
  CHECK(turns.triangles.size() == front.triangles.size());
  CHECK(volume(turns) == doctest::Approx(volume(front)));
}

TEST_CASE("only whole components that are closed without their doubles lose them") {
  RepairReport report;
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 1, 8);
  TriangleMesh sheets{{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  TriangleMesh mesh = together({ball, sheets});
  dropDoubled(mesh, report);
  CHECK(mesh.triangles.size() == ball.triangles.size() + 2);
  TriangleMesh partly = ball;
  partly.triangles.push_back(ball.triangles[7]);
  dropDoubled(partly, report);
  CHECK(partly.triangles.size() == ball.triangles.size() + 1);
  CHECK(report.trianglesDoubled == 0);
  // A doubled ball beside a sound one.
  TriangleMesh beside = cubeOf(1, 10);
  TriangleMesh twice = ball;
  twice.triangles.insert(twice.triangles.end(), ball.triangles.begin(), ball.triangles.end());
  mesh = together({beside, twice});
  dropDoubled(mesh, report);
  CHECK(mesh.triangles.size() == beside.triangles.size() + ball.triangles.size());
  CHECK(topology(mesh).manifold());
}
