#include "geometry/repair/repair.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/repair/hole.h"
#include "geometry/repair/mesh_health.h"
#include "geometry/topology.h"

using namespace resect;

namespace {

TriangleMesh withoutTriangles(TriangleMesh mesh, int every, int offset) {
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (int(i % std::size_t(every)) != offset) kept.push_back(mesh.triangles[i]);
  mesh.triangles = kept;
  return mesh;
}

}  // namespace

TEST_CASE("the health of a ball, a ball inside out, and an open ball") {
  TriangleMesh ball = sphereMesh({0, 0, 0}, 0.1);
  MeshHealth health = examine(ball);
  CHECK(health.closed);
  CHECK(health.oriented);
  CHECK_FALSE(health.insideOut);
  CHECK(health.components == 1);
  CHECK(health.specks == 0);
  CHECK(health.volume == volume(ball));

  flip(ball);
  health = examine(ball);
  CHECK(health.closed);
  CHECK(health.insideOut);

  ball.triangles.pop_back();
  health = examine(ball);
  CHECK_FALSE(health.closed);
  CHECK_FALSE(health.insideOut);
  CHECK(health.boundaryEdges == 3);
  CHECK(health.firstBoundaryPoint);
  CHECK_FALSE(examine({}).closed);
}

TEST_CASE("a cavity looks inwards and is not inside out; a body beside may be") {
  TriangleMesh shell = sphereMesh({0, 0, 0}, 1);
  TriangleMesh cavity = sphereMesh({0.2, 0, 0}, 0.5);
  flip(cavity);
  append(shell, cavity);
  CHECK_FALSE(examine(shell).insideOut);
  RepairReport report;
  const double before = volume(shell);
  turnOutwards(shell, report);
  CHECK(report.componentsTurned == 0);
  CHECK(volume(shell) == before);

  // The shell and its cavity turned together come back as they were; a sound neighbour stays.
  flip(shell);
  append(shell, sphereMesh({5, 0, 0}, 1));
  CHECK(examine(shell).insideOut);
  turnOutwards(shell, report);
  CHECK(report.componentsTurned == 2);
  CHECK_FALSE(examine(shell).insideOut);
  CHECK(volume(shell) == doctest::Approx(before + volume(sphereMesh({5, 0, 0}, 1))));
}

TEST_CASE("thousands of bubbles in a ball are cavities, those beside it are bodies") {
  TriangleMesh mesh = sphereMesh({0, 0, 0}, 1, 60);
  const double ball = volume(mesh);
  double bubbles = 0;
  Random random(9);
  for (int i = 0; i < 4000; ++i) {
    Vec3 centre(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const bool inside = centre.norm() < 0.95;
    if (!inside && centre.norm() < 1.05) continue;
    TriangleMesh bubble = boxMesh({centre - Vec3::Constant(1e-3), centre + Vec3::Constant(1e-3)});
    if (inside) flip(bubble);
    bubbles += volume(bubble);
    append(mesh, bubble);
  }
  CHECK_FALSE(examine(mesh).insideOut);
  flip(mesh);
  CHECK(examine(mesh).insideOut);
  RepairReport report;
  turnOutwards(mesh, report);
  CHECK(volume(mesh) == doctest::Approx(ball + bubbles));
}

TEST_CASE("randomly turned triangles agree again after orienting") {
  const TriangleMesh torus = torusMesh({0, 0, 0}, 2, 0.5);
  TriangleMesh mesh = torus;
  Random random(3);
  for (Triangle& t : mesh.triangles)
    if (random.below(3) == 0) std::swap(t[0], t[1]);
  CHECK_FALSE(topology(mesh).oriented());
  RepairReport report;
  orientConsistently(mesh, report);
  CHECK(topology(mesh).oriented());
  CHECK(volume(mesh) == doctest::Approx(volume(torus)));  // the majority looked outwards
  CHECK(report.trianglesTurned > 0);
}

TEST_CASE("a missing triangle is put back exactly") {
  TriangleMesh mesh = boxMesh({{0, 0, 0}, {1, 2, 3}});
  const Triangle missing = mesh.triangles.back();
  mesh.triangles.pop_back();
  const auto loops = holeLoops(mesh);
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].size() == 3);
  RepairReport report;
  closeHoles(mesh, report);
  CHECK(report.holesClosed == 1);
  CHECK(report.trianglesAdded == 1);
  CHECK(topology(mesh).closed());
  CHECK(topology(mesh).oriented());
  CHECK(volume(mesh) == doctest::Approx(6));
  std::array<std::int32_t, 3> back = mesh.triangles.back(), gone = missing;
  std::sort(back.begin(), back.end());
  std::sort(gone.begin(), gone.end());
  CHECK(back == gone);
}

TEST_CASE("the open end of a box is closed flat, and the volume change is told") {
  // Without the top: seen from the middle of the box, a sixth of the volume is missing.
  TriangleMesh mesh = boxMesh({{0, 0, 0}, {1, 1, 1}});
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return mesh.points[t[0]].y() == 1 && mesh.points[t[1]].y() == 1 && mesh.points[t[2]].y() == 1;
  });
  RepairReport report;
  closeHoles(mesh, report);
  CHECK(report.trianglesAdded == 2);
  CHECK(report.areaAdded == doctest::Approx(1));
  CHECK(report.volumeBefore == doctest::Approx(5.0 / 6));
  CHECK(report.volumeAfter == doctest::Approx(1));
  CHECK(volume(mesh) == doctest::Approx(1));
}

TEST_CASE("holes that touch in a point are closed one by one") {
  // Two opposite triangles of the fan round the pole: the holes share the pole.
  TriangleMesh mesh = sphereMesh({0, 0, 0}, 1, 4);
  const double before = volume(mesh);
  std::vector<std::size_t> pole;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles[i][0] == 0) pole.push_back(i);
  REQUIRE(pole.size() == 8);
  mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(pole[4]));
  mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(pole[0]));
  CHECK(holeLoops(mesh).size() == 2);
  RepairReport report;
  closeHoles(mesh, report);
  CHECK(topology(mesh).closed());
  CHECK(volume(mesh) == doctest::Approx(before));
}

TEST_CASE("whatever is taken away, closing gives a closed and oriented surface") {
  const TriangleMesh whole = torusMesh({0, 0, 0}, 2, 0.7, 40, 20);
  for (int every = 2; every < 40; every += 3)
    for (int offset = 0; offset < every; offset += 1 + every / 2) {
      TriangleMesh mesh = withoutTriangles(whole, every, offset);
      RepairReport report;
      closeHoles(mesh, report);
      CHECK(topology(mesh).closed());
      CHECK(topology(mesh).oriented());
      CHECK(report.holesClosed > 0);
    }
}

TEST_CASE("edges of three triangles are closed too") {
  // Three fins on one edge: five points, no inside at all.
  TriangleMesh mesh{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                    {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  RepairReport report;
  closeHoles(mesh, report);
  CHECK(topology(mesh).closed());
  CHECK(topology(mesh).oriented());
}

TEST_CASE("a hole of a thousand edges is closed by a disc") {
  TriangleMesh cone{{{0, 1, 0}}, {}};
  const int n = 1000;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    cone.points.emplace_back(std::sin(a), 0, std::cos(a));
    cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  RepairReport report;
  closeHoles(cone, report);
  CHECK(topology(cone).closed());
  CHECK(report.trianglesAdded == n - 2);
  // The inscribed polygon's area, less than pi by 2 pi^3 / (3 n^2).
  CHECK(report.areaAdded == doctest::Approx(std::numbers::pi).epsilon(1e-5));
  CHECK(volume(cone) == doctest::Approx(std::numbers::pi / 3).epsilon(1e-5));
}

TEST_CASE("a crack is filled with a sliver, not with a flap") {
  // Two bent rims, 1e-5 apart: the filling of least area zigzags between them.
  TriangleMesh mesh = sphereMesh({0, 0, 0}, 1, 24);
  const double before = volume(mesh), whole = area(mesh);
  // Cut open along a meridian: the points of sector 0 are doubled and moved by a hair.
  const auto count = std::int32_t(mesh.points.size());
  const int sectors = 48;
  std::vector<std::int32_t> twin(mesh.points.size(), -1);
  for (std::int32_t i = 1; i + 1 < count; i += sectors) {
    twin[i] = std::int32_t(mesh.points.size());
    mesh.points.push_back(mesh.points[i] + Vec3(-1e-5, 0, 0));
  }
  for (Triangle& t : mesh.triangles) {
    const double x = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]).x();
    if (x >= 0) continue;
    for (std::int32_t& i : t)
      if (i < count && twin[i] >= 0 && mesh.points[i].z() > 0) i = twin[i];
  }
  CHECK_FALSE(topology(mesh).closed());
  RepairReport report;
  closeHoles(mesh, report);
  CHECK(topology(mesh).closed());
  CHECK(report.areaAdded < 1e-5 * std::numbers::pi * 1.1);
  CHECK(area(mesh) == doctest::Approx(whole).epsilon(1e-4));
  CHECK(volume(mesh) == doctest::Approx(before).epsilon(1e-4));
}

TEST_CASE("specks without volume are dropped, thin bodies are kept") {
  TriangleMesh mesh = sphereMesh({0, 0, 0}, 0.1);
  const std::size_t ball = mesh.triangles.size();
  append(mesh, boxMesh({{1, 0, 0}, {2, 1e-3, 1e-3}}));                        // a wire
  append(mesh, {{{3, 0, 0}, {4, 0, 0}, {3, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});  // two sheets
  CHECK(examine(mesh).specks == 1);
  RepairReport report;
  dropSpecks(mesh, report);
  CHECK(report.specksDropped == 1);
  CHECK(mesh.triangles.size() == ball + 12);
  CHECK(examine(mesh).components == 2);
  CHECK(examine(mesh).specks == 0);
}
