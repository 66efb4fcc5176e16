// Has every column exactly the steps that the exact test of every triangle gives it, where the
// bounds of single precision are narrowest? Steps say more than stretches: shells within others
// show.
#include "collision/span_caster.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision/footprint.h"
#include "collision/span_samples.h"
#include "geometry/measures.h"
#include "support/sampled_shells.h"

#if defined(__x86_64__)
using namespace resect;

namespace {

using StepsOfRow = std::vector<std::pair<std::int32_t, Step>>;  // column and step, sorted

std::vector<StepsOfRow> stepsByAllTriangles(const GridOnMesh& grid, const SampleLine& line) {
  std::vector<StepsOfRow> rows(std::size_t(grid.rows.count));
  for (std::size_t t = 0; t < grid.mesh.triangles.size(); ++t) {
    const Footprint footprint = footprintOf(grid.mesh, t);
    if (footprint.area == 0) continue;
    const auto& [a, b, c] = grid.mesh.triangles[t];
    const auto reach = [&](const GridLines& lines, auto of) {
      const auto [low, high] = std::minmax({of(a), of(b), of(c)});
      const auto begin = lines.at.begin(), end = begin + lines.count;
      return std::pair(int(std::lower_bound(begin, end, low) - begin),
                       int(std::lower_bound(begin, end, high) - begin));
    };
    const auto place = [&](std::int32_t p) { return grid.mesh.places[std::size_t(p)]; };
    const auto [left, right] = reach(grid.columns, [&](auto p) { return place(p).x; });
    const auto [first, last] = reach(grid.rows, [&](auto p) { return place(p).y; });
    for (int y = first; y < last; ++y)
      for (int x = left; x < right; ++x) {
        const auto at =
            footprint.row(grid.rows.at[std::size_t(y)]).place(grid.columns.at[std::size_t(x)]);
        if (at.covered())
          rows[std::size_t(y)].push_back({x, step(line.upTo(footprint.depth(at)), footprint.sign)});
      }
  }
  for (StepsOfRow& row : rows) std::ranges::sort(row);
  return rows;
}

StepsOfRow stepsOf(StepRows& rows, int y) {
  StepsOfRow steps;
  for (int x = 0; x < rows.columns(); ++x) {
    const auto add = [&](StepPair pair) {
      for (const Step s : {lowerOf(pair), upperOf(pair)})
        if (s != kNoStep) steps.push_back({x, s});
    };
    add(rows.pairs()[rows.place(y, x)]);
    if (rows.row(y).deep) add(rows.deepPairs()[rows.place(y, x)]);
  }
  for (const auto& [place, s] : rows.row(y).more) steps.push_back({rows.cell(place).column, s});
  std::ranges::sort(steps);
  return steps;
}

// How many steps there are, the same both ways.
std::size_t compare(const TriangleMesh& mesh, const ColumnGrid& grid, const SampleLine& line) {
  const SnappedMesh snapped = snapToRaster(mesh);
  GridOnMesh lines(snapped, grid);
  REQUIRE(RoughMesh::isEnough(lines));
  const std::vector<StepsOfRow> expected = stepsByAllTriangles(lines, line);
  const RoughMesh rough(std::move(lines));
  StepRows rows(grid.countX, grid.countY);
  SpanCaster(rough, line).cast(0, mesh.triangles.size(), rows);
  std::size_t steps = 0;
  for (int y = 0; y < grid.countY; ++y) {
    REQUIRE(stepsOf(rows, y) == expected[std::size_t(y)]);
    steps += expected[std::size_t(y)].size();
  }
  return steps;
}

void addTetrahedron(TriangleMesh& mesh, const Vec3 (&corners)[4]) {
  const auto first = std::int32_t(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners, corners + 4);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  mesh.triangles.push_back({first, first + 3, first + 1});
  mesh.triangles.push_back({first + 1, first + 3, first + 2});
}

// Tetrahedra within the unit cube, the corners of which belong to the mesh: what the raster is.
TriangleMesh tetrahedra(Random& random, int count, double size) {
  TriangleMesh mesh;
  for (int k = 0; k < count; ++k) {
    const Vec3 centre(random.uniform(), random.uniform(), random.uniform());
    Vec3 corners[4];
    for (Vec3& p : corners)
      p = centre + size * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    addTetrahedron(mesh, corners);
  }
  mesh.points.push_back({0, 0, 0});
  mesh.points.push_back({1, 1, 1});
  return mesh;
}

// Of either sign, between 10^-most and 10^-least.
double tiny(Random& random, double least, double most) {
  return std::pow(10, -random.uniform(least, most)) * (random.below(2) ? 1 : -1);
}

}  // namespace

TEST_CASE("a column on a triangle, often near its edge, at a depth near a point's") {
  if (!canFindSpans()) return;
  Random random(71);
  std::size_t steps = 0;
  for (int k = 0; k < 20'000; ++k) {
    const int n = 1 + random.below(random.below(3) ? 20 : 100);
    const double pitch = 1.0 / n;
    TriangleMesh mesh = tetrahedra(random, 1, random.below(2) ? 0.5 : 3 * pitch);
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    if (random.below(2)) v = tiny(random, 3, 10);
    const Vec3 on = mesh.points[0] + u * (mesh.points[1] - mesh.points[0]) +
                    v * (mesh.points[2] - mesh.points[0]);
    const SampleLine line{0, 1.0 / (1 + random.below(3000)), 3000};
    const double depth =
        (std::round(on.z() / line.pitch) + tiny(random, 3, 10)) * line.pitch - on.z();
    for (int c = 0; c < 4; ++c) mesh.points[std::size_t(c)].z() += depth;
    const ColumnGrid grid{
        {on.x() - pitch * random.below(n), on.y() - pitch * random.below(n)}, {pitch, pitch}, n, n};
    steps += compare(mesh, grid, line);
  }
  CHECK(steps > 1'000'000);
}

TEST_CASE("lines so fine that the raster itself is coarse") {
  if (!canFindSpans()) return;
  Random random(72);
  std::size_t steps = 0;
  for (int k = 0; k < 1500; ++k) {
    TriangleMesh mesh = tetrahedra(random, 12, random.below(2) ? 0.5 : 1e-6);
    const double step = bounds(mesh).size().head<2>().maxCoeff() / kRaster;
    const double pitch = step * random.uniform(21, 40);
    const int n = 10 + random.below(60);
    const Vec3 at = mesh.points[std::size_t(random.below(48))];
    for (int t = 0; t < 12; ++t)
      if (random.below(2))
        for (int c = 0; c < 4; ++c)
          mesh.points[std::size_t(4 * t + c)] =
              at + Vec3(random.uniform(-1, 1) * pitch * n, random.uniform(-1, 1) * pitch * n,
                        random.uniform(-1, 1));
    const ColumnGrid grid{
        {at.x() - pitch * n * random.uniform(), at.y() - pitch * n / 2}, {pitch, pitch}, n, n};
    steps += compare(mesh, grid, {0, 1.0 / 500, 500});
  }
  CHECK(steps > 500'000);
}

TEST_CASE("corners on lines and points, or a few steps of the raster beside them") {
  if (!canFindSpans()) return;
  Random random(73);
  std::size_t steps = 0;
  for (int k = 0; k < 3000; ++k) {
    const int n = 1 + random.below(random.below(3) ? 20 : 100);
    const double pitch = 1.0 / n;
    TriangleMesh mesh = tetrahedra(random, 6, random.below(2) ? 0.5 : 2 * pitch);
    const SampleLine line{0, 1.0 / 300, 300};
    const auto beside = [&](double& x) {
      if (random.below(2) && x > 0 && x < 1)
        x = std::round(x / pitch) * pitch + (random.below(41) - 20) * 0x1p-30;
    };
    for (Vec3& p : mesh.points) {
      beside(p.x());
      beside(p.y());
      if (random.below(2)) p.z() = std::round(p.z() / line.pitch) * line.pitch;
    }
    const int rows = std::min(n, 1000);
    steps +=
        compare(mesh, {{0, pitch * random.below(n - rows + 1)}, {pitch, pitch}, n, rows}, line);
  }
  CHECK(steps > 100'000);
}

TEST_CASE("as many columns as there may be, crossed by small triangles") {
  if (!canFindSpans()) return;
  Random random(75);
  constexpr int n = 1 << 15;
  constexpr double kPitch = 1.0 / n;
  std::size_t steps = 0;
  for (int k = 0; k < 30; ++k) {
    TriangleMesh mesh = tetrahedra(random, 3000, kPitch);
    for (std::size_t t = 0; t < 3000; ++t) {
      const Vec3 to(mesh.points[4 * t].x(), 6 * kPitch * random.uniform(), 0.008);
      const Vec3 away = to - mesh.points[4 * t];
      for (std::size_t c = 0; c < 4; ++c) mesh.points[4 * t + c] += away;
    }
    steps += compare(mesh, {{0, 0}, {kPitch, kPitch}, n, 6}, {0, 1e-6, kMostPoints});
  }
  CHECK(steps > 50'000);
}

TEST_CASE("shells on whole numbers at any scale, columns on thirds and eighths of them") {
  if (!canFindSpans()) return;
  Random random(74);
  std::size_t steps = 0;
  for (int k = 0; k < 1500; ++k) {
    TriangleMesh mesh = randomDegenerateShells(random, 1 + random.below(6));
    const double scale = std::pow(10, random.below(9) - 4);
    for (Vec3& p : mesh.points) p *= scale;
    const int n = 5 + random.below(50);
    const double pitch = (k % 3 == 0 ? 0.5 : k % 3 == 1 ? 8.0 / n : 1.0 / 3) * scale;
    const ColumnGrid grid{
        {(random.below(5) - 1) * scale, (random.below(5) - 1) * scale}, {pitch, pitch}, n, n};
    const double apart = (random.below(2) ? 0.25 : 0.5) / (random.below(2) ? 1 : 3);
    steps += compare(mesh, grid, {(random.below(3) - 1) * scale, apart * scale, 40});
  }
  CHECK(steps > 500'000);
}

TEST_CASE("a mesh far from the origin, where numbers are coarse: spans, or the plain path") {
  if (!canFindSpans()) return;
  const TriangleMesh ball = turnedBall(40);
  const SampleLine line{-1, 0.01, 200};
  for (const double far : {1e6, 1e9, 1e10, 1e11, 1e12, 1e13, 1e15})
    for (int n = 60; n < 120; n += 5) {
      TriangleMesh mesh = ball;
      for (Vec3& p : mesh.points) p += Vec3(far, far, 0);
      const ColumnGrid grid{{far - 1, far - 1}, {2.0 / n, 2.0 / n}, n, n};
      const SnappedMesh snapped = snapToRaster(mesh);
      if (far <= 1e11) CHECK(compare(mesh, grid, line) > 1000);
      if (far >= 1e13) CHECK_FALSE(RoughMesh::isEnough({snapped, grid}));
      const InsideSamples spans = insideSamplesBySpans(snapped, grid, line),
                          plain = insideSamplesPlainly(snapped, grid, line);
      for (std::size_t j = 0; j < std::size_t(n); ++j)
        for (std::size_t i = 0; i < std::size_t(n); ++i)
          REQUIRE(std::ranges::equal(spans.column(i, j), plain.column(i, j)));
    }
}
#endif
