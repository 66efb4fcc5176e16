#include "collision/columns.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "support/malformed/degenerate_mesh.h"
#include "support/references/mesh_reference.h"

using namespace resect;

namespace {

int sumOfSigns(std::span<const Crossing> column) {
  int sum = 0;
  for (const Crossing& c : column) sum += c.sign;
  return sum;
}

bool sorted(std::span<const Crossing> column) {
  for (std::size_t i = 1; i < column.size(); ++i)
    if (column[i].depth < column[i - 1].depth) return false;
  return true;
}

bool equal(const Crossings& a, const Crossings& b) {
  if (a.offsets != b.offsets || a.all.size() != b.all.size()) return false;
  for (std::size_t i = 0; i < a.all.size(); ++i)
    if (a.all[i].depth != b.all[i].depth || a.all[i].sign != b.all[i].sign) return false;
  return true;
}

Crossings castOneByOne(const SnappedMesh& snapped, const ColumnGrid& grid) {
  std::vector<Vec2> places;
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i)
      places.push_back(grid.origin + Vec2(i * grid.pitch.x(), j * grid.pitch.y()));
  return castColumns(snapped, places);
}

// Every column is balanced, and the same on the grid and in a list. How many crossings there are.
std::size_t castBothWays(const TriangleMesh& mesh, const ColumnGrid& grid) {
  const SnappedMesh snapped = snapToRaster(mesh);
  const Crossings columns = castColumns(snapped, grid);
  REQUIRE(columns.columnCount() == grid.count());
  REQUIRE(equal(columns, castOneByOne(snapped, grid)));
  for (std::size_t c = 0; c < columns.columnCount(); ++c) {
    REQUIRE(sumOfSigns(columns[c]) == 0);
    REQUIRE(sorted(columns[c]));
  }
  return columns.all.size();
}

// Tetrahedra of about that size in the unit cube; they overlap each other.
TriangleMesh tetrahedra(Random& random, int count, double size) {
  TriangleMesh mesh;
  for (int k = 0; k < count; ++k) {
    const Vec3 centre(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    const auto corner = [&] { return random.uniform(-size, size); };
    const auto first = std::int32_t(mesh.points.size());
    Vec3 p[4];
    for (Vec3& q : p) q = centre + Vec3(corner(), corner(), corner());
    if ((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) > 0) std::swap(p[1], p[2]);
    mesh.points.insert(mesh.points.end(), p, p + 4);
    for (const auto& [a, b, c] : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      mesh.triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

double insideLength(const Crossings& columns) {
  double sum = 0;
  for (std::size_t c = 0; c < columns.columnCount(); ++c)
    forEachInside(columns[c], [&](double a, double b) { sum += b - a; });
  return sum;
}

}  // namespace

TEST_CASE("every column of 1000 random degenerate closed meshes is balanced") {
  Random random(7);
  long crossings = 0;
  for (int round = 0; round < 1000; ++round) {
    const TriangleMesh mesh = randomDegenerateMesh(random);
    REQUIRE(topology(mesh).unorientedEdges == 0);
    // Columns on the points' raster, half a step beside it, and one that fits nothing.
    const double pitch = round % 3 == 0 ? 1 : round % 3 == 1 ? 0.5 : 0.37;
    crossings += long(
        castBothWays(mesh, {{-1, -1}, {pitch, pitch}, int(10 / pitch) + 1, int(10 / pitch) + 1}));
  }
  CHECK(crossings > 100000);
}

TEST_CASE("soups of tetrahedra, tiny, large and both; slivers and steep faces") {
  Random random(43);
  std::size_t crossings = 0;
  for (int k = 0; k < 60; ++k) {
    TriangleMesh mesh = tetrahedra(random, 60, k % 2 ? 0.02 : 0.7);
    append(mesh, tetrahedra(random, 200, 0.01));
    // All but on a line, seen from above, or all but upright.
    const double thin = std::pow(10, -random.uniform(0, 9));
    for (Vec3& p : mesh.points)
      if (k % 4 == 1)
        p.x() = p.y() * 0.7 + thin * p.x();
      else if (k % 4 == 2)
        p.z() *= 1 / thin;
    for (const int n : {9, 64, 130})
      crossings += castBothWays(mesh, {{0, 0}, {1.0 / n, 1.0 / n}, n, n});
  }
  CHECK(crossings > 1'000'000);
}

TEST_CASE("corners on columns, or a few steps of the raster beside them, and columns as near") {
  Random random(73);
  std::size_t crossings = 0;
  for (int k = 0; k < 1000; ++k) {
    const int n = 1 + random.below(random.below(3) ? 20 : 100);
    const double pitch = 1.0 / n;
    TriangleMesh mesh = tetrahedra(random, 6, random.below(2) ? 0.5 : 2 * pitch);
    const auto beside = [&](double& x) {
      if (random.below(2)) x = std::round(x / pitch) * pitch + (random.below(41) - 20) * 0x1p-30;
    };
    for (Vec3& p : mesh.points) beside(p.x()), beside(p.y());
    crossings += castBothWays(mesh, {{0, 0}, {pitch, pitch}, n, n});
    const double step = bounds(mesh).size().maxCoeff() * 0x1p-30 * random.uniform(0.3, 40);
    const Vec2 at = mesh.points[std::size_t(random.below(24))].head<2>();
    crossings += castBothWays(mesh, {at - Vec2::Constant(step * n / 2), {step, step}, n, n});
  }
  CHECK(crossings > 100'000);
}

TEST_CASE("a mesh far from the origin, where numbers are coarse") {
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 1, 40);
  for (const double far : {1e6, 1e9, 1e10, 1e11, 1e12, 1e13, 1e15, 1e17})
    for (int n = 60; n < 120; n += 5) {
      TriangleMesh mesh = ball;
      for (Vec3& p : mesh.points) p += Vec3(far, far, 0);
      const std::size_t crossings =
          castBothWays(mesh, {{far - 1, far - 1}, {2.0 / n, 2.0 / n}, n, n});
      if (far <= 1e11) CHECK(crossings > 1000);
    }
}

TEST_CASE("a box aligned with the columns holds exactly the half-open share of them") {
  const TriangleMesh box = boxMesh({{0, 0, 1}, {4, 4, 3}});
  const Crossings columns = castColumns(snapToRaster(box), ColumnGrid{{-1, -1}, {1, 1}, 7, 7});
  for (int j = -1; j < 6; ++j)
    for (int i = -1; i < 6; ++i) {
      const auto column = columns[(j + 1) * 7 + i + 1];
      const bool covered = i >= 0 && i < 4 && j >= 0 && j < 4;
      REQUIRE(column.size() == (covered ? 2 : 0));
      if (!covered) continue;
      CHECK(column[0].depth == 1);
      CHECK(column[0].sign == 1);
      CHECK(column[1].depth == 3);
      CHECK(column[1].sign == -1);
    }
}

TEST_CASE("overlapping, nested and touching shells count as their union") {
  TriangleMesh mesh = boxMesh({{0, 0, 0}, {1, 1, 2}});
  append(mesh, boxMesh({{0, 0, 1}, {1, 1, 3}}));       // overlaps
  append(mesh, boxMesh({{0, 0, 3}, {1, 1, 4}}));       // touches
  append(mesh, boxMesh({{0, 0, 0.25}, {1, 1, 0.5}}));  // nested
  append(mesh, boxMesh({{0, 0, 6}, {1, 1, 7}}));       // apart
  TriangleMesh cavity = boxMesh({{0, 0, 6.25}, {1, 1, 6.5}});
  flip(cavity);
  append(mesh, cavity);
  const Vec2 place(0.5, 0.4);
  const Crossings column = castColumns(snapToRaster(mesh), std::span(&place, 1));
  std::vector<double> ends;
  forEachInside(column[0], [&](double a, double b) { ends.insert(ends.end(), {a, b}); });
  CHECK(ends == std::vector<double>{0, 4, 6, 6.25, 6.5, 7});
  const std::vector<Vec3> points{{0.5, 0.4, 1.5}, {0.5, 0.4, 0.3}, {0.5, 0.4, 6.4},
                                 {0.5, 0.4, 5},   {0.5, 0.4, 3},   {2, 0.4, 0.3}};
  CHECK(windingNumbers(snapToRaster(mesh), points) == std::vector<std::int32_t>{2, 2, 0, 0, 1, 0});
}

TEST_CASE("winding numbers equal the solid angle over 4 pi") {
  Random random(3);
  TriangleMesh mesh = torusMesh({0, 0, 0}, 1, 0.4, 20, 11);
  append(mesh, sphereMesh({0.5, 0.2, 0.3}, 0.7, 7));
  mesh = transformed(mesh, {{0.1, 0.2, 0.3}, Eigen::Quaterniond(0.3, 0.5, -0.2, 0.7).normalized()});
  std::vector<Vec3> points;
  for (int i = 0; i < 3000; ++i)
    points.emplace_back(random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6),
                        random.uniform(-1.6, 1.6));
  const auto winding = windingNumbers(snapToRaster(mesh), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double reference = test::solidAngleWinding(mesh, points[i]);
    CHECK(winding[i] == std::lround(reference));
  }
}

TEST_CASE("the volume under the columns of a sphere converges to the sphere's") {
  const TriangleMesh sphere = sphereMesh({0.3, 0.1, -0.2}, 1, 40);
  for (const int n : {8, 32, 128}) {
    const double pitch = 2.2 / n;
    const Crossings columns =
        castColumns(snapToRaster(sphere),
                    ColumnGrid{{-0.8 + pitch / 2, -1.0 + pitch / 2}, {pitch, pitch}, n, n});
    const double error = std::abs(insideLength(columns) * pitch * pitch / volume(sphere) - 1);
    // A column near the silhouette errs by half its length at most: pitch^(3/2) in all.
    CHECK(error < std::pow(n, -1.5));
  }
}

TEST_CASE("crossings are the same bits at 1, 2 and 3 threads") {
  const TriangleMesh mesh = torusMesh({0, 0, 0}, 1, 0.4, 200, 100);
  const ColumnGrid grid{{-1.5, -0.5}, {3.0 / 90, 1.0 / 70}, 91, 71};
  std::vector<Vec2> places;
  Random random(5);
  for (int i = 0; i < 5000; ++i)
    places.emplace_back(random.uniform(-1.5, 1.5), random.uniform(-0.5, 0.5));
  Crossings first, listed;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    const Crossings again = castColumns(snapToRaster(mesh), grid);
    const Crossings listedAgain = castColumns(snapToRaster(mesh), places);
    if (threads == 1) {
      first = again;
      listed = listedAgain;
    }
    CHECK(equal(first, again));
    CHECK(equal(listed, listedAgain));
  }
  CHECK(first.all.size() > 1000);
  CHECK(listed.all.size() > 1000);
}

TEST_CASE("a grid's columns cross what the same columns cross in a list, whatever the threads") {
  // So many triangles that several threads share them.
  const TriangleMesh mesh = torusMesh({0, 0, 0}, 1, 0.4, 400, 200);
  const ColumnGrid grid{{-1.5, -0.5}, {3.0 / 90, 1.0 / 70}, 91, 71};
  const SnappedMesh snapped = snapToRaster(mesh);
  const Crossings listed = castOneByOne(snapped, grid);
  CHECK(listed.all.size() > 1000);
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    CHECK(equal(listed, castColumns(snapped, grid)));
  }
}

TEST_CASE("nothing crosses an empty mesh, and no columns give no crossings") {
  const TriangleMesh nothing;
  CHECK(castColumns(snapToRaster(nothing), ColumnGrid{{0, 0}, {1, 1}, 3, 3}).all.empty());
  CHECK(castColumns(snapToRaster(nothing), ColumnGrid{{0, 0}, {1, 1}, 3, 3}).columnCount() == 9);
  const TriangleMesh box = boxMesh({{0, 0, 0}, {1, 1, 1}});
  CHECK(castColumns(snapToRaster(box), ColumnGrid{{0, 0}, {1, 1}, 0, 3}).columnCount() == 0);
  CHECK(castColumns(snapToRaster(box), std::span<const Vec2>{}).columnCount() == 0);
  // Columns far beside the mesh, and columns much finer than the raster.
  CHECK(castColumns(snapToRaster(box), ColumnGrid{{1e9, -1e9}, {1e9, 1e9}, 5, 5}).all.empty());
  CHECK(castColumns(snapToRaster(box), ColumnGrid{{0.5, 0.5}, {1e-15, 1e-15}, 20, 20}).all.size() ==
        800);
}
