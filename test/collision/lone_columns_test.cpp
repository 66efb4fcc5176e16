// Do the columns of small triangles, four at a time, equal the plain test bit for bit?
#include "collision/lone_columns.h"

#include <doctest/doctest.h>

#include <bit>

#include "base/random.h"
#include "collision/footprint.h"

using namespace resect;

namespace {

// Triangles with corners anywhere on the raster, or on every n-th step of it, so that columns meet
// edges and corners; some without area, some with corners far apart.
struct Case {
  std::vector<Triangle> triangles;
  SnappedMesh mesh;
  std::vector<std::int32_t> lines;
  std::vector<LoneColumn> lone;

  Case(Random& random, int grain) {
    const auto place = [&] {
      return std::int32_t(random.uniform(0, 1.0 * (1 << 30) / grain)) * grain;
    };
    for (int i = 0; i < 30; ++i) mesh.points.push_back({place(), place(), random.uniform(-1, 1)});
    for (int i = 0; i < 200; ++i) {
      const auto corner = [&] { return std::int32_t(random.uniform(0, 29.99)); };
      triangles.push_back({corner(), corner(), corner()});
    }
    mesh.triangles = triangles;
    for (int i = 0; i < 40; ++i)
      lines.push_back(random.uniform() < 0.5 ? mesh.points[std::size_t(i) % 30].x : place());
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

TEST_CASE("columns of four triangles at a time are those of one, bit for bit") {
  Random random(11);
  std::size_t covered = 0;
  for (int k = 0; k < 400; ++k) {
    const Case c(random, k % 2 == 0 ? 1 : 1 << 28);
    const GridRaster raster{c.lines.data(), c.lines.data()};
    const std::size_t count = c.lone.size() - std::size_t(k) % 4;
    std::vector<LoneHit> wide(count + 1), plain(count + 1);
    const auto wideEnd = castLone(c.mesh, raster, c.lone.data(), count, wide.data());
    const auto plainEnd = castLonePlainly(c.mesh, raster, c.lone.data(), count, plain.data());
    REQUIRE(wideEnd - wide.data() == plainEnd - plain.data());
    for (LoneHit *w = wide.data(), *p = plain.data(); w < wideEnd; ++w, ++p) {
      const GridHit &a = w->hit, &b = p->hit;
      CHECK(w->row == p->row);
      CHECK(a.column == b.column);
      CHECK(a.sign == b.sign);
      CHECK(std::bit_cast<std::uint64_t>(a.depth) == std::bit_cast<std::uint64_t>(b.depth));
      ++covered;
    }
  }
  CHECK(covered > 5000);
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
  std::vector<LoneColumn> lone(triangles.size());
  std::vector<std::uint32_t> others(triangles.size());
  const SortedOut count =
      sortOut(triangles, cells.data(), 3, triangles.size(), lone.data(), others.data());
  std::size_t l = 0, o = 0;
  for (std::uint32_t t = 3; t < triangles.size(); ++t) {
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
