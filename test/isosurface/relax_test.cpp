#include "isosurface/relax.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/measures.h"
#include "geometry/topology.h"

using namespace resect;

namespace {

double smallBall(const Vec3& p) { return p.norm() - 0.01; }

// Octahedron in the ball: all its edges cut off much of it.
TriangleMesh octahedron() {
  TriangleMesh mesh;
  for (int m = 0; m < 3; ++m)
    for (double sign : {0.01, -0.01}) mesh.points.push_back(sign * Vec3::Unit(m));
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

}  // namespace

TEST_CASE("splitting puts a point on the surface over every edge that cuts a corner") {
  TriangleMesh mesh = octahedron();
  CHECK(splitCuttingEdges(smallBall, mesh) == 12);
  CHECK(mesh.points.size() == 18);
  CHECK(mesh.triangles.size() == 32);
  for (const Vec3& p : mesh.points) CHECK(std::abs(smallBall(p)) < 1e-5);
  CHECK(topology(mesh).closed());
  CHECK(topology(mesh).oriented());
  const double before = volume(mesh);
  // Finer and finer: the edges come to lie flat, and nothing is left to split.
  while (splitCuttingEdges(smallBall, mesh) > 0) CHECK(mesh.points.size() < 1000);
  CHECK(topology(mesh).closed());
  CHECK(topology(mesh).oriented());
  CHECK(topology(mesh).manifold());
  CHECK(volume(mesh) >= before);
}

TEST_CASE("a triangle with one or two split sides keeps its neighbours") {
  // A ball with a flat top: some edges cut corners, those on top do not.
  const auto flat = [](const Vec3& p) { return std::max(p.norm() - 0.01, p.y() - 0.004); };
  TriangleMesh mesh = octahedron();
  for (Vec3& p : mesh.points) p.y() = std::min(p.y(), 0.004);
  for (int round = 0; round < 4; ++round) splitCuttingEdges(flat, mesh, 0.05);
  CHECK(topology(mesh).closed());
  CHECK(topology(mesh).oriented());
  CHECK(topology(mesh).manifold());
}

TEST_CASE("evening out keeps points on the surface and an empty mesh empty") {
  TriangleMesh mesh = octahedron();
  for (int round = 0; round < 3; ++round) splitCuttingEdges(smallBall, mesh, 0.01);
  for (int round = 0; round < 5; ++round) evenOut(smallBall, mesh, 0.003);
  for (const Vec3& p : mesh.points) CHECK(std::abs(smallBall(p)) < 1e-4);
  TriangleMesh nothing;
  evenOut(smallBall, nothing, 0.003);
  CHECK(splitCuttingEdges(smallBall, nothing) == 0);
  CHECK(nothing.points.empty());
}
