// Are the points of a grid that lie inside a body those that the crossings of its columns say?
#include "collision/inside_samples.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/parallel.h"
#include "base/random.h"
#include "support/sampled_shells.h"

using namespace resect;

namespace {

// Every point of the grid, from the sorted crossings: how many shells are round it.
std::vector<std::uint8_t> flagsByCrossings(const SnappedMesh& mesh, const ColumnGrid& grid,
                                           const SampleLine& line) {
  std::vector<std::uint8_t> flags;
  const Crossings crossings = castColumns(mesh, grid);
  for (std::size_t c = 0; c < crossings.columnCount(); ++c)
    for (std::int32_t k = 0; k < line.count; ++k) {
      int winding = 0;
      for (const Crossing& crossing : crossings[c])
        if (crossing.depth < line.at(k)) winding += crossing.sign;
      flags.push_back(winding > 0);
    }
  return flags;
}

std::vector<std::uint8_t> flagsOf(const InsideSamples& inside, const ColumnGrid& grid,
                                  const SampleLine& line) {
  std::vector<std::uint8_t> flags(grid.count() * std::size_t(line.count), 0);
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i) {
      std::int32_t last = -1;
      for (const InsideStretch& s : inside.column(std::size_t(i), std::size_t(j))) {
        CHECK(s.first > last);  // upwards, not touching, not empty
        CHECK(s.last > s.first);
        CHECK(s.last <= line.count);
        last = s.last;
        const std::size_t column = std::size_t(j) * std::size_t(grid.countX) + std::size_t(i);
        for (std::int32_t k = s.first; k < s.last; ++k)
          flags[column * std::size_t(line.count) + std::size_t(k)] = 1;
      }
    }
  return flags;
}

std::int64_t compare(const TriangleMesh& mesh, const ColumnGrid& grid, const SampleLine& line) {
  const SnappedMesh snapped = snapToRaster(mesh);
  const auto expected = flagsByCrossings(snapped, grid, line);
  const auto flags = flagsOf(insideSamples(snapped, grid, line), grid, line);
  CHECK(flags == expected);
  std::int64_t inside = 0;
  for (const std::uint8_t flag : flags) inside += flag;
  return inside;
}

}  // namespace

TEST_CASE("points of a grid are inside where its crossings say") {
  Random random(31);
  std::int64_t inside = 0;
  for (int k = 0; k < 200; ++k) {
    const SampledShells shells(random, k, 40);
    inside += compare(shells.mesh, shells.grid, shells.line);
    inside += compare(shells.mesh, shells.grid, shells.within);
  }
  CHECK(inside > 10000);
}

TEST_CASE("points on a face: outside a lower one, inside an upper one") {
  const TriangleMesh mesh = boxMesh({{0, 0, 1}, {1, 1, 2}});
  const InsideSamples inside =
      insideSamples(snapToRaster(mesh), {{0.5, 0.5}, {1, 1}, 1, 1}, {0, 0.25, 12});
  REQUIRE(inside.column(0, 0).size() == 1);
  CHECK(inside.column(0, 0)[0].first == 5);  // 1.25
  CHECK(inside.column(0, 0)[0].last == 9);   // 2 is the last
}

TEST_CASE("points inside are the same at 1, 2 and 3 threads") {
  Random random(32);
  TriangleMesh mesh;
  for (int n = 0; n < 5; ++n) append(mesh, sphereMesh({4, 4, 4}, 3 + random.uniform(), 64));
  const SnappedMesh snapped = snapToRaster(mesh);
  const ColumnGrid grid{{0, 0}, {0.04, 0.04}, 200, 200};
  const SampleLine line{0, 0.05, 160};
  const auto flags = [&](int threads) {
    const ThreadLimit limit(threads);
    return flagsOf(insideSamples(snapped, grid, line), grid, line);
  };
  const auto one = flags(1);
  CHECK(flags(2) == one);
  CHECK(flags(3) == one);
}

TEST_CASE("no mesh holds no points, and no columns have none") {
  const TriangleMesh none, box = boxMesh({{0, 0, 0}, {1, 1, 1}});
  CHECK(insideSamples(snapToRaster(none), {{0, 0}, {1, 1}, 2, 2}, {0, 1, 4}).column(1, 1).empty());
  CHECK(insideSamples(snapToRaster(box), {{0, 0}, {1, 1}, 0, 2}, {0, 1, 4}).all.empty());
  CHECK(
      insideSamples(snapToRaster(box), {{0.5, 0.5}, {1, 1}, 1, 1}, {0, 1, 0}).column(0, 0).empty());
}
