// Points of a line inside a body agree with its column's crossings.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "collision/columns.h"
#include "support/malformed/degenerate_mesh.h"

using namespace resect;

namespace {

// From the crossings one by one: how many shells are round each point.
std::vector<std::uint8_t> flagsOneByOne(std::span<const Crossing> column, const SampleLine& line) {
  std::vector<std::uint8_t> flags;
  for (std::int32_t k = 0; k < line.count; ++k) {
    int winding = 0;
    for (const Crossing& crossing : column)
      if (crossing.depth < line.at(k)) winding += crossing.sign;
    flags.push_back(winding > 0);
  }
  return flags;
}

std::vector<std::uint8_t> flagsOf(std::span<const Crossing> column, const SampleLine& line) {
  std::vector<std::uint8_t> flags(std::size_t(line.count), 0);
  std::int32_t last = 0;
  forEachInside(column, line, [&](std::int32_t first, std::int32_t end) {
    CHECK(first >= last);  // upwards, not empty
    CHECK(end > first);
    CHECK(end <= line.count);
    last = end;
    for (std::int32_t k = first; k < end; ++k) flags[std::size_t(k)] = 1;
  });
  return flags;
}

// How many points lie inside.
std::int64_t compare(const TriangleMesh& mesh, const ColumnGrid& grid, const SampleLine& line) {
  const Crossings columns = castColumns(snapToRaster(mesh), grid);
  std::int64_t inside = 0;
  for (std::size_t c = 0; c < columns.columnCount(); ++c) {
    const std::vector<std::uint8_t> flags = flagsOf(columns[c], line);
    REQUIRE(flags == flagsOneByOne(columns[c], line));
    for (const std::uint8_t flag : flags) inside += flag;
  }
  return inside;
}

}  // namespace

TEST_CASE("shells that overlap and touch: points are inside where the crossings say") {
  Random random(31);
  std::int64_t inside = 0;
  for (int k = 0; k < 200; ++k) {
    const TriangleMesh mesh = randomDegenerateShells(random, k % 7 + 1);
    const int n = 1 + random.below(40);
    const ColumnGrid grid{{0, -0.5}, {8.0 / n, 9.0 / n}, n, n + 3};
    // In every third case points lie on faces; the second line begins and ends within.
    inside += compare(mesh, grid, {-0.25, k % 3 == 0 ? 0.25 : 8.7 / n, n});
    inside += compare(mesh, grid, {3, 0.01, n});
    // Columns and points on the mesh's own coordinates, where corners, edges and faces lie.
    inside += compare(mesh, {{0, 0}, {0.5, 0.5}, 17, 17}, {0, 0.5, 17});
  }
  CHECK(inside > 10000);
}

TEST_CASE("points on a face: outside a lower one, inside an upper one") {
  const TriangleMesh mesh = boxMesh({{0, 0, 1}, {1, 1, 2}});
  const Crossings columns = castColumns(snapToRaster(mesh), ColumnGrid{{0.5, 0.5}, {1, 1}, 1, 1});
  int stretches = 0;
  forEachInside(columns[0], {0, 0.25, 12}, [&](std::int32_t first, std::int32_t end) {
    CHECK(first == 5);  // 1.25
    CHECK(end == 9);    // 2 is the last
    ++stretches;
  });
  CHECK(stretches == 1);
  forEachInside(columns[0], {0, 1, 0}, [&](std::int32_t, std::int32_t) { FAIL("no points"); });
}

TEST_CASE("a mesh of any size, and any number of points, ending within or far beyond it") {
  TriangleMesh mesh = transformed(sphereMesh({0, 0, 0}, 1, 20),
                                  {{0, 0, 0}, Eigen::Quaterniond(0.8, 0.3, 0.2, 0.1).normalized()});
  for (const double scale : {1e-6, 1.0, 1e6}) {
    TriangleMesh scaled = mesh;
    for (Vec3& p : scaled.points) p *= scale;
    const ColumnGrid grid{{-scale, -scale}, {scale / 7, scale / 7}, 15, 15};
    for (const std::int32_t count : {0, 1, 2, 1000, 20'000}) {
      const std::int64_t inside =
          compare(scaled, grid, {-0.9 * scale, 1.8 * scale / (count + 1), count});
      if (count >= 1000) CHECK(inside > 0);
      compare(scaled, grid, {-1e3 * scale, scale, count});
    }
  }
}
