// Are small triangles tested four at a time as the plain test has it?
#include "collision/lone_columns.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "collision/footprint.h"

using namespace resect;

namespace {

// Triangles with corners anywhere on the raster, or on every n-th step of it, so that columns meet
// edges and corners; some without area, some with corners far apart.
struct Case {
  std::vector<Triangle> triangles;
  std::vector<Vec3> points;
  SnappedMesh mesh;
  std::vector<std::int32_t> lines;
  std::vector<LoneColumn> lone;

  Case(Random& random, int grain) {
    const auto place = [&] {
      return std::int32_t(random.uniform(0, 1.0 * (1 << 30) / grain)) * grain;
    };
    for (int i = 0; i < 30; ++i) {
      mesh.places.push_back({place(), place()});
      points.emplace_back(0, 0, random.uniform(-1, 1));
    }
    mesh.points = points;
    for (int i = 0; i < 200; ++i) {
      const auto corner = [&] { return std::int32_t(random.uniform(0, 29.99)); };
      triangles.push_back({corner(), corner(), corner()});
    }
    mesh.triangles = triangles;
    for (int i = 0; i < 40; ++i)
      lines.push_back(random.uniform() < 0.5 ? mesh.places[std::size_t(i) % 30].x : place());
    lines.push_back(kBelow);
    lines.push_back(kAbove);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      lone.push_back(
          {t, {std::int32_t(random.uniform(0, 41.99)), std::int32_t(random.uniform(0, 41.99))}});
    for (std::uint32_t t = 0; t < 100; ++t)  // and columns over one of the corners
      lone.push_back({t, {triangles[t][0], triangles[t][1]}});
  }
};

}  // namespace

TEST_CASE("of four triangles at a time those are kept that the plain test keeps") {
  Random random(11);
  std::size_t covered = 0, onEdges = 0;
  for (int k = 0; k < 400; ++k) {
    const Case c(random, k % 2 == 0 ? 1 : 1 << 28);
    const GridRaster raster{c.lines.data(), c.lines.data()};
    std::vector<LoneColumn> wide = c.lone, plain = c.lone;
    const std::size_t count = c.lone.size() - std::size_t(k) % 4;
    wide.resize(keepCovering(c.mesh, raster, wide.data(), count));
    plain.resize(keepCoveringPlainly(c.mesh, raster, plain.data(), count));
    REQUIRE(wide.size() == plain.size());
    for (std::size_t i = 0; i < wide.size(); ++i) {
      CHECK(wide[i].triangle == plain[i].triangle);
      CHECK(wide[i].at.column == plain[i].at.column);
      CHECK(wide[i].at.row == plain[i].at.row);
      const Footprint footprint = footprintOf(c.mesh, wide[i].triangle);
      const auto place = footprint.row(c.lines[std::size_t(wide[i].at.row)])
                             .place(c.lines[std::size_t(wide[i].at.column)]);
      CHECK(footprint.area > 0);
      CHECK(place.covered());
      for (const std::int64_t v : {place.v0, place.v1, place.v2}) onEdges += v == 0;
    }
    covered += wide.size();
  }
  CHECK(covered > 5000);
  CHECK(onEdges > 100);
}

TEST_CASE("triangles are sorted out by the lines between their corners") {
  Random random(12);
  std::vector<GridCell> cells;
  for (int i = 0; i < 50; ++i)
    cells.push_back({std::int32_t(random.uniform(0, 3.99)), std::int32_t(random.uniform(0, 2.99))});
  std::vector<Triangle> triangles;
  for (int i = 0; i < 1000; ++i) {
    const auto corner = [&] { return std::int32_t(random.uniform(0, 49.99)); };
    triangles.push_back({corner(), corner(), corner()});
  }
  // Four at a time and plainly, from one place and the next, so that some are left over.
  for (std::uint32_t begin = 3; begin < 7; ++begin)
    for (const auto sort : {sortOut, sortOutPlainly}) {
      std::vector<LoneColumn> lone(triangles.size() + 3);
      std::vector<std::uint64_t> others(triangles.size() + 3);
      const SortedOut count =
          sort(triangles, cells.data(), begin, triangles.size(), lone.data(), others.data());
      std::size_t l = 0, o = 0;
      for (std::uint32_t t = begin; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        const auto [left, right] = std::minmax({cells[a].column, cells[b].column, cells[c].column});
        const auto [lower, upper] = std::minmax({cells[a].row, cells[b].row, cells[c].row});
        if (right == left || upper == lower) continue;
        if (right - left == 1 && upper - lower == 1) {
          REQUIRE(l < count.lone);
          CHECK(lone[l].triangle == t);
          CHECK(lone[l].at.column == left);
          CHECK(lone[l++].at.row == lower);
        } else {
          REQUIRE(o < count.others);
          CHECK(others[o++] == t);
        }
      }
      CHECK(l == count.lone);
      CHECK(o == count.others);
      CHECK(l > 50);
      CHECK(o > 50);
    }
}
