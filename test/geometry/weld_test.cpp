#include "geometry/repair/weld.h"

#include <doctest/doctest.h>

#include <cmath>
#include <iterator>
#include <set>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"

using namespace resect;

namespace {

// Every triangle with three points of its own.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const Triangle& t : mesh.triangles) {
    const auto n = std::int32_t(result.points.size());
    for (const std::int32_t i : t) result.points.push_back(mesh.points[i]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

}  // namespace

TEST_CASE("a soup of triangles welds to the mesh it came from") {
  const TriangleMesh torus = torusMesh({1, 2, 3}, 2, 0.5);
  WeldReport report;
  const TriangleMesh welded = weld(soup(torus), 0, &report);
  CHECK(welded.points.size() == torus.points.size());
  CHECK(welded.triangles.size() == torus.triangles.size());
  CHECK(report.mergedPoints == int(3 * torus.triangles.size() - torus.points.size()));
  CHECK(report.degenerateTriangles == 0);
  const Topology t = topology(welded);
  CHECK(t.closed());
  CHECK(t.oriented());
  CHECK(volume(welded) == volume(soup(torus)));
  // Triangles keep their order and their corners' places.
  for (std::size_t i = 0; i < welded.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(welded.points[welded.triangles[i][k]] == torus.points[torus.triangles[i][k]]);
}

TEST_CASE("zero and minus zero are one place") {
  const TriangleMesh mesh{{{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}},
                          {{0, 1, 2}, {3, 2, 1}}};
  CHECK(weld(mesh).points.size() == 3);
}

TEST_CASE("welding drops degenerate triangles and unused points, and keeps flat ones") {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {9, 9, 9}},
                          {{0, 1, 1}, {0, 1, 3}, {0, 1, 2}}};
  WeldReport report;
  const TriangleMesh welded = weld(mesh, 0, &report);
  CHECK(welded.triangles.size() == 1);
  CHECK(welded.points.size() == 3);
  CHECK(report.degenerateTriangles == 2);
  CHECK(report.mergedPoints == 1);
  CHECK(report.unusedPoints == 1);
}

TEST_CASE("a tolerance joins what rounding has parted, and nothing further away") {
  const TriangleMesh sphere = sphereMesh({0, 0, 0}, 0.1);
  TriangleMesh shaken = soup(sphere);
  const double diagonal = bounds(sphere).size().norm();
  Random random(7);
  for (Vec3& p : shaken.points)
    for (int k = 0; k < 3; ++k) p[k] += random.uniform(-1, 1) * 1e-8 * diagonal;
  CHECK_FALSE(topology(weld(shaken)).closed());
  const TriangleMesh welded = weld(shaken, 1e-6);
  CHECK(welded.points.size() == sphere.points.size());
  CHECK(topology(welded).closed());
  CHECK(topology(weld(shaken, 1e-12)).boundaryEdges > 0);
}

TEST_CASE("welding nothing gives nothing") {
  CHECK(weld({}).triangles.empty());
  CHECK(weld({}, 1e-6).points.empty());
}

TEST_CASE("equal points are those found by comparing each with all before it") {
  Random random(12);
  TriangleMesh mesh;
  for (int i = 0; i < 3000; ++i) {
    // Few places in all; 0 and -0, neighbours in the last digit, sizes far apart.
    const auto coordinate = [&] {
      const double all[] = {0.0, -0.0, 1.0, std::nextafter(1.0, 2.0), -1e-300, 1e9, -0.1, 1.0 / 3};
      return all[random.below(std::size(all))];
    };
    mesh.points.emplace_back(coordinate(), coordinate(), coordinate());
  }
  for (int i = 0; i < 6000; ++i) {
    const auto corner = [&] { return std::int32_t(random.below(mesh.points.size())); };
    mesh.triangles.push_back({corner(), corner(), corner()});
  }
  const auto firstLike = [&](std::int32_t i) {
    std::int32_t first = 0;
    while (mesh.points[std::size_t(first)] != mesh.points[std::size_t(i)]) ++first;
    return first;
  };
  const TriangleMesh welded = weld(mesh);
  std::set<std::int32_t> used;
  std::size_t next = 0;
  for (const Triangle& t : mesh.triangles) {
    const Triangle first{firstLike(t[0]), firstLike(t[1]), firstLike(t[2])};
    if (first[0] == first[1] || first[1] == first[2] || first[2] == first[0]) continue;
    used.insert(first.begin(), first.end());
    REQUIRE(next < welded.triangles.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& found = welded.points[std::size_t(welded.triangles[next][k])];
      CHECK(found == mesh.points[std::size_t(first[k])]);
      CHECK(std::signbit(found.x()) == std::signbit(mesh.points[std::size_t(first[k])].x()));
    }
    ++next;
  }
  CHECK(next == welded.triangles.size());
  CHECK(used.size() == welded.points.size());
}
