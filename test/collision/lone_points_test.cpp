// Do numbers of single precision sort triangles out as the exact test does, wherever they decide?
#include "collision/lone_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "collision/footprint.h"
#include "collision/span_samples.h"
#include "support/sampled_shells.h"

#if defined(__x86_64__)
using namespace resect;

namespace {

struct Counts {
  std::size_t lone = 0, unsure = 0, steps = 0, larger = 0;
};

// Checks every triangle of a mesh, run by run.
Counts compare(const TriangleMesh& mesh, const ColumnGrid& grid, const SampleLine& line) {
  const SnappedMesh snapped = snapToRaster(mesh);
  REQUIRE(RoughMesh::isEnough(GridOnMesh(snapped, grid)));
  const RoughMesh rough{GridOnMesh(snapped, grid)};
  const MeshOnGrid exact(snapped, grid);
  const GridRaster raster = exact.raster();
  const auto run = std::make_unique<SortedRun>();
  Counts counts;
  for (std::size_t begin = 0; begin < mesh.triangles.size(); begin += kRun) {
    const std::size_t end = std::min(begin + kRun, mesh.triangles.size());
    sortOutRoughly(rough, begin, end, *run);
    Step steps[SortedRun::kRoom];
    findSteps(rough, line, slackOf(line), *run, steps);
    const std::set<std::int32_t> lone(run->triangle, run->triangle + run->lone),
        unsure(run->doubtful, run->doubtful + run->unsure),
        larger(run->larger, run->larger + run->others);
    REQUIRE(lone.size() + unsure.size() + larger.size() == run->lone + run->unsure + run->others);
    for (std::size_t t = begin; t < end; ++t) {
      const auto number = std::int32_t(t);
      const auto [columns, rows] = exact.reach(t);
      REQUIRE(rough.reach(t).first.first == columns.first);
      REQUIRE(rough.reach(t).first.last == columns.last);
      REQUIRE(rough.reach(t).second.first == rows.first);
      REQUIRE(rough.reach(t).second.last == rows.last);
      const bool some = columns.size() > 0 && rows.size() > 0;
      const bool single = some && columns.size() == 1 && rows.size() == 1;
      if (!single) {  // what reaches beyond the grid's end, too, may be among the larger ones
        REQUIRE(larger.contains(number) == some);
        REQUIRE(!lone.contains(number));
        REQUIRE(!unsure.contains(number));
        continue;
      }
      const Footprint footprint = footprintOf(snapped, t);
      const bool covered =
          footprint.area > 0 &&
          footprint.row(raster.rows[rows.first]).place(raster.columns[columns.first]).covered();
      if (lone.contains(number)) REQUIRE(covered);
      if (covered && !lone.contains(number))
        REQUIRE((unsure.contains(number) || larger.contains(number)));
    }
    for (std::size_t k = 0; k < run->lone; ++k) {
      const auto triangle = std::size_t(run->triangle[k]);
      const auto [columns, rows] = exact.reach(triangle);
      REQUIRE(columns.first == run->column[k]);
      REQUIRE(rows.first == run->row[k]);
      if (steps[k] == kNoStep) continue;
      ++counts.steps;
      const Footprint footprint = footprintOf(snapped, triangle);
      const auto place =
          footprint.row(raster.rows[rows.first]).place(raster.columns[columns.first]);
      REQUIRE(steps[k] == step(line.upTo(footprint.depth(place)), footprint.sign));
    }
    counts.lone += run->lone;
    counts.unsure += run->unsure;
    counts.larger += run->others;
  }
  return counts;
}

}  // namespace

TEST_CASE("a fine mesh: hardly a triangle is left in doubt") {
  if (!canFindSpans()) return;
  const TriangleMesh ball = turnedBall(150);
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const int n : {30, 61, 100}) {
      TriangleMesh mesh = ball;
      for (Vec3& p : mesh.points) p *= scale;
      const Counts counts =
          compare(mesh, squareGrid(-scale, scale, n), {-scale, 2 * scale / 256, 256});
      CHECK(counts.lone > 1000);
      CHECK(counts.unsure < counts.lone / 50);
      CHECK(counts.steps > counts.lone * 19 / 20);
    }
}

TEST_CASE("columns, rows and points on the mesh's own coordinates, slivers, flat triangles") {
  if (!canFindSpans()) return;
  Random random(61);
  Counts all;
  for (int k = 0; k < 300; ++k) {
    const TriangleMesh mesh = randomDegenerateShells(random, k % 9 + 1);
    const Counts counts = compare(
        mesh,
        k % 2 ? ColumnGrid{{0, 0}, {0.5, 0.5}, 17, 17} : ColumnGrid{{1.5, 2}, {3.5, 2.25}, 3, 4},
        {0, 0.5, 17});
    all.lone += counts.lone;
    all.unsure += counts.unsure;
    all.larger += counts.larger;
  }
  CHECK(all.lone > 1000);
  CHECK(all.unsure > 100);
  CHECK(all.larger > 10000);
}

TEST_CASE("half of the mesh beside the grid, and a grid as fine as single precision bears") {
  if (!canFindSpans()) return;
  const TriangleMesh ball = turnedBall(90);
  const SampleLine line{-1, 2.0 / 1000, 1000};
  CHECK(compare(ball, {{0.01, -2}, {0.021, 0.02}, 40, 300}, line).lone > 1000);
  CHECK(compare(ball, {{-1, -0.1}, {2.0 / (1 << 15), 0.021}, 1 << 15, 7}, line).larger > 1000);
  const double least = 2.0 / (1 << 26);  // sixteen steps of the raster
  compare(ball, {{0.1, 0.1}, {1.9 * least, 1.9 * least}, 9, 9}, line);
  const SnappedMesh snapped = snapToRaster(ball);
  CHECK_FALSE(RoughMesh::isEnough({snapped, {{0, 0}, {least, 1}, 9, 9}}));
  CHECK_FALSE(RoughMesh::isEnough({snapped, {{0, 0}, {1, 1}, 1, (1 << 15) + 1}}));
  CHECK_FALSE(RoughMesh::isEnough({snapped, {{1e16, 0}, {1, 1}, 1, 1}}));
}
#endif
