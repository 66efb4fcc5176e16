// Do spans of columns, found in single precision, give the same stretches as the plain path?
#include "collision/span_samples.h"

#include <doctest/doctest.h>
#include <algorithm>
#include <map>
#include <utility>

#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "base/random.h"
#include "collision/step_rows.h"
#include "support/sampled_shells.h"

using namespace resect;

namespace {

// Of all columns: their stretches, one after the other, with the number of the column.
std::vector<std::int32_t> listed(const InsideSamples& inside, const ColumnGrid& grid) {
  std::vector<std::int32_t> all;
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i)
      for (const InsideStretch& s : inside.column(std::size_t(i), std::size_t(j)))
        all.insert(all.end(), {j * grid.countX + i, s.first, s.last});
  return all;
}

// How many stretches there are; the same on both paths, by spans at 1, 2 and 3 threads.
std::size_t compare(const TriangleMesh& mesh, const ColumnGrid& grid, const SampleLine& line) {
  const SnappedMesh snapped = snapToRaster(mesh);
  const auto expected = listed(insideSamplesPlainly(snapped, grid, line), grid);
  if (!canFindSpans()) return expected.size() / 3;
  std::vector<std::uint32_t> offsets;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    const InsideSamples inside = insideSamplesBySpans(snapped, grid, line);
    CHECK(listed(inside, grid) == expected);
    if (threads == 1) offsets = inside.offsets;
    CHECK(inside.offsets == offsets);
  }
  return expected.size() / 3;
}

// Tetrahedra, which overlap each other.
TriangleMesh soup(Random& random, int triangles, double size) {
  TriangleMesh mesh;
  for (int k = 0; k < triangles; ++k) {
    const Vec3 centre(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    const auto corner = [&] { return random.uniform(-size, size); };
    const auto first = std::int32_t(mesh.points.size());
    for (int c = 0; c < 4; ++c) mesh.points.push_back(centre + Vec3(corner(), corner(), corner()));
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    mesh.triangles.push_back({first, first + 3, first + 1});
    mesh.triangles.push_back({first + 1, first + 3, first + 2});
  }
  return mesh;
}

}  // namespace

TEST_CASE("spans: shells that overlap and touch, faces on the points") {
  Random random(41);
  std::size_t stretches = 0;
  for (int k = 0; k < 150; ++k) {
    const SampledShells shells(random, k, 60);
    stretches += compare(shells.mesh, shells.grid, shells.line);
    // Columns and points on the mesh's own coordinates, where corners, edges and faces lie.
    stretches += compare(shells.mesh, {{0, 0}, {0.5, 0.5}, 17, 17}, {0, 0.5, 17});
    stretches += compare(shells.mesh, shells.grid, shells.within);
  }
  CHECK(stretches > 10000);
}

TEST_CASE("spans: a mesh of any size, any number of points, a grid of any width") {
  Random random(42);
  const TriangleMesh ball = turnedBall(20);
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const std::int32_t count : {1, 2, 1000, kMostPoints})
      for (const int n : {1, 2, 3, 4, 5, 7, 8, 33, 61}) {
        TriangleMesh mesh = ball;
        for (Vec3& p : mesh.points) p *= scale;
        const std::size_t stretches =
            compare(mesh, squareGrid(-scale, scale, n), {-0.9 * scale, 1.8 * scale / count, count});
        if (count >= 1000) CHECK(stretches > 0);
        // Half of it beside the mesh; then a pitch far above the mesh's size, and far below.
        compare(mesh, squareGrid(0, 2 * scale, n), {-0.9 * scale, 1.8 * scale / count, count});
        compare(mesh, {{-50 * scale, -3 * scale}, {25 * scale, 3 * scale}, n, n},
                {0, scale, count});
        compare(mesh, {{0.1 * scale, 0.2 * scale}, {1e-10 * scale, 1e-9 * scale}, n, n},
                {-scale, 2 * scale / count, count});
      }
}

TEST_CASE("spans: soups of triangles, tiny, large and both") {
  Random random(43);
  std::size_t stretches = 0;
  for (int k = 0; k < 40; ++k) {
    TriangleMesh mesh = soup(random, 60, k % 2 ? 0.02 : 0.7);
    append(mesh, soup(random, 200, 0.01));
    for (const int n : {9, 64, 130})
      stretches += compare(mesh, squareGrid(0, 1, n), {0, 1.0 / 200, 200});
  }
  CHECK(stretches > 100000);
}

TEST_CASE("spans: slivers and steep faces") {
  Random random(44);
  std::size_t stretches = 0;
  for (int k = 0; k < 60; ++k) {
    TriangleMesh mesh = soup(random, 100, 0.5);
    // All but on a line, seen from above, or all but upright.
    const double thin = std::pow(10, -random.uniform(0, 9));
    for (Vec3& p : mesh.points)
      if (k % 2)
        p.x() = p.y() * 0.7 + thin * p.x();
      else
        p.z() *= 1 / thin;
    stretches += compare(mesh, squareGrid(0, 1, 50), {0, 1.0 / 300, 300});
  }
  CHECK(stretches > 10000);
}

TEST_CASE("spans: a fine mesh, a box of twelve triangles and a diagonal one round it") {
  TriangleMesh mesh = sphereMesh({0.5, 0.5, 0.5}, 0.3, 100);
  const std::size_t alone = compare(mesh, squareGrid(0, 1, 150), {0, 1.0 / 256, 256});
  append(mesh, boxMesh({{0.01, 0.02, 0.03}, {0.97, 0.98, 0.99}}));
  CHECK(compare(mesh, squareGrid(0, 1, 150), {0, 1.0 / 256, 256}) > alone);
  const TriangleMesh turned =
      transformed(boxMesh({{-0.01, -2, -0.01}, {0.01, 2, 0.01}}),
                  {{0.5, 0.5, 0.5}, Eigen::Quaterniond(0.9, 0.1, 0.2, 0.4).normalized()});
  append(mesh, turned);
  for (const int n : {150, 257, 512})
    CHECK(compare(mesh, squareGrid(0, 1, n), {0, 1.0 / 256, 256}) > 0);
}

TEST_CASE("spans: more steps in a column than two pairs hold, at any number of threads") {
  TriangleMesh mesh;
  for (int n = 0; n < 9; ++n) append(mesh, sphereMesh({0.5, 0.5, 0.5}, 0.05 * (n + 1), 30 + n));
  for (int n = 0; n < 9; ++n)  // nine plates above one another: eighteen steps, nine stretches
    append(mesh, boxMesh({{0, 0, 1 + 0.1 * n}, {1, 1, 1.05 + 0.1 * n}}));
  CHECK(compare(mesh, squareGrid(-0.1, 1.1, 97), {0, 1.0 / 100, 200}) > 9 * 6000);
}

TEST_CASE("spans: fewer rows than threads, on a large grid") {
  if (!canFindSpans()) return;
  const TriangleMesh ball = sphereMesh({0.5, 0.5, 0.5}, 0.45, 120);
  const SnappedMesh snapped = snapToRaster(ball);
  const ColumnGrid grid = squareGrid(0, 1, 1100);
  const SampleLine line{0, 1.0 / 300, 300};
  const auto expected = listed(insideSamplesPlainly(snapped, grid, line), grid);
  const ThreadLimit limit(6);
  CHECK(threadsAllowed() == 6);
  CHECK(listed(insideSamplesBySpans(snapped, grid, line), grid) == expected);
}

#if defined(__x86_64__)
TEST_CASE(
    "spans: steps of two sets, merged, are the lowest of both in order, and the rest listed") {
  if (!canFindSpans()) return;
  Random random(45);
  constexpr int kColumns = 13, kRows = 7;
  for (const int most : {2, 4, 11}) {  // steps that a column may get
    StepRows rows(kColumns, kRows), other(kColumns, kRows);
    std::map<std::pair<int, int>, std::vector<int>> steps;
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kColumns; ++x)
        for (int k = random.below(most + 1); k > 0; --k) {
          const int s = random.below(2 * kMostPoints + 2);
          (random.below(2) == 0 ? rows : other).insert(rows.place(y, x), Step(s));
          steps[{y, x}].push_back(s);
        }
    for (int y = 0; y < kRows; ++y) rows.merge(other, y);
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kColumns; ++x) {
        std::vector<int> found;
        const auto add = [&](StepPair pair) {
          for (const Step s : {lowerOf(pair), upperOf(pair)})
            if (s != kNoStep) found.push_back(int(s));
        };
        add(rows.pairs()[rows.place(y, x)]);
        if (rows.row(y).deep) add(rows.deepPairs()[rows.place(y, x)]);
        std::vector<int> more;
        for (const auto& [at, s] : rows.row(y).more)
          if (at == rows.place(y, x)) more.push_back(int(s));
        std::sort(more.begin(), more.end());
        found.insert(found.end(), more.begin(), more.end());
        std::vector<int>& expected = steps[{y, x}];
        std::sort(expected.begin(), expected.end());
        REQUIRE(found == expected);
        if (expected.size() > 4) REQUIRE(more.size() == expected.size() - 4);
      }
  }
}
#endif

TEST_CASE("as many points as spans take and one more") {
  const TriangleMesh mesh = turnedBall(12);
  const SnappedMesh snapped = snapToRaster(mesh);
  const ColumnGrid grid = squareGrid(-1, 1, 30);
  for (const std::int32_t count : {0, kMostPoints, kMostPoints + 1}) {
    const SampleLine line{-1, 1.5 / (count + 1), count};  // ends within
    const InsideSamples some = insideSamples(snapped, grid, line),
                        plain = insideSamplesPlainly(snapped, grid, line);
    for (std::size_t j = 0; j < 30; ++j)
      for (std::size_t i = 0; i < 30; ++i)
        REQUIRE(std::ranges::equal(some.column(i, j), plain.column(i, j)));
  }
}
