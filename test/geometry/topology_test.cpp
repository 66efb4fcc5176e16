#include "geometry/topology.h"

#include <doctest/doctest.h>

#include <numbers>

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
