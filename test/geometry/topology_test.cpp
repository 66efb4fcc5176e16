#include "geometry/topology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"

using namespace resect;

TEST_CASE("primitives are closed, oriented, manifold and look outwards") {
  const Aabb box{{-1, -2, -3}, {4, 5, 6}};
  for (const TriangleMesh& mesh :
       {boxMesh(box), sphereMesh({1, 2, 3}, 0.5), torusMesh({0, 1, 0}, 2, 0.5)}) {
    const Topology t = topology(mesh);
    CHECK(t.closed());
    CHECK(t.oriented());
    CHECK(t.manifold());
    CHECK(t.components == 1);
    CHECK(volume(mesh) > 0);
  }
  CHECK(volume(boxMesh(box)) == doctest::Approx(5 * 7 * 9));
  CHECK(area(boxMesh(box)) == doctest::Approx(2 * (35 + 45 + 63)));
  CHECK((centroid(boxMesh(box)) - box.centre()).norm() < 1e-12);
  // An inscribed polyhedron of 48 x 96 faces misses about 2 * pi^2 / (3 * 48^2) of the volume at
  // the most.
  CHECK(volume(sphereMesh({1, 2, 3}, 0.5, 48)) ==
        doctest::Approx(4.0 / 3 * std::numbers::pi * 0.125).epsilon(3e-3));
}

TEST_CASE("a missing triangle opens three edges and the report says where") {
  TriangleMesh mesh = boxMesh({{0, 0, 0}, {1, 1, 1}});
  mesh.triangles.pop_back();
  const Topology t = topology(mesh);
  CHECK_FALSE(t.closed());
  CHECK(t.boundaryEdges == 3);
  REQUIRE(t.firstBoundaryPoint);
  CHECK(bounds(mesh).contains(*t.firstBoundaryPoint));
  CHECK(t.oriented());  // what is left is wound one way
}

TEST_CASE("a turned triangle leaves the mesh closed but not oriented") {
  TriangleMesh mesh = sphereMesh({0, 0, 0}, 1, 6);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const Topology t = topology(mesh);
  CHECK(t.closed());
  CHECK(t.unorientedEdges == 3);
}

TEST_CASE("splitting into components keeps every triangle and each piece closed") {
  TriangleMesh mesh = boxMesh({{0, 0, 0}, {1, 1, 1}});
  append(mesh, sphereMesh({5, 0, 0}, 1));
  append(mesh, torusMesh({0, 5, 0}, 2, 0.5));
  const auto pieces = splitComponents(mesh);
  REQUIRE(pieces.size() == 3);
  std::size_t triangles = 0;
  double sum = 0;
  for (const TriangleMesh& piece : pieces) {
    CHECK(topology(piece).closed());
    triangles += piece.triangles.size();
    sum += volume(piece);
  }
  CHECK(triangles == mesh.triangles.size());
  CHECK(sum == doctest::Approx(volume(mesh)));
}

TEST_CASE("an empty mesh is closed and has no component") {
  const Topology t = topology({});
  CHECK(t.closed());
  CHECK(t.components == 0);
}

TEST_CASE("edges and pieces are those counted one by one") {
  Random random(5);
  for (int round = 0; round < 40; ++round) {
    // Few points, so that edges meet in every way; corners may be equal.
    const int points = 3 + int(random.below(30));
    TriangleMesh mesh;
    for (int i = 0; i < points; ++i) mesh.points.emplace_back(i, 0.5 * i, -i);
    const auto triangles = random.below(60);
    for (int i = 0; i < triangles; ++i) {
      const auto corner = [&] { return std::int32_t(random.below(std::uint64_t(points))); };
      mesh.triangles.push_back({corner(), corner(), corner()});
    }
    std::map<std::pair<std::int32_t, std::int32_t>, std::pair<int, int>> edges;  // up, down
    std::map<std::int32_t, std::set<std::int32_t>> neighbours;
    for (const Triangle& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const std::int32_t a = t[i], b = t[(i + 1) % 3];
        auto& [up, down] = edges[std::minmax(a, b)];
        ++(a < b ? up : down);
        neighbours[a].insert(b);
        neighbours[b].insert(a);
      }
    Topology expected;
    for (const auto& [ends, uses] : edges) {
      const int all = uses.first + uses.second;
      if (all % 2 == 1 && expected.boundaryEdges++ == 0)
        expected.firstBoundaryPoint =
            0.5 * (mesh.points[std::size_t(ends.first)] + mesh.points[std::size_t(ends.second)]);
      expected.nonManifoldEdges += all > 2;
      expected.unorientedEdges += std::abs(uses.first - uses.second) > all % 2;
    }
    while (!neighbours.empty()) {
      ++expected.components;
      std::vector<std::int32_t> reached{neighbours.begin()->first};
      for (std::size_t i = 0; i < reached.size(); ++i)
        if (const auto node = neighbours.extract(reached[i]))
          reached.insert(reached.end(), node.mapped().begin(), node.mapped().end());
    }
    const Topology found = topology(mesh);
    CHECK(found.boundaryEdges == expected.boundaryEdges);
    CHECK(found.nonManifoldEdges == expected.nonManifoldEdges);
    CHECK(found.unorientedEdges == expected.unorientedEdges);
    CHECK(found.components == expected.components);
    CHECK(found.firstBoundaryPoint == expected.firstBoundaryPoint);
  }
}
