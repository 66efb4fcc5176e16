// Do the columns of large triangles, four at a time, equal the plain test bit for bit?
#include "collision/column_box.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "base/random.h"

using namespace resect;

namespace {

std::vector<GridHit> sorted(std::span<const GridHit> hits) {
  std::vector<GridHit> result(hits.begin(), hits.end());
  std::sort(result.begin(), result.end(),
            [](const GridHit& a, const GridHit& b) { return a.column < b.column; });
  return result;
}

// The lines between the lowest and the highest of a triangle's corners along one axis.
std::pair<int, int> linesBetween(const std::vector<std::int32_t>& lines, std::int32_t low,
                                 std::int32_t high) {
  return {int(std::lower_bound(lines.begin(), lines.end(), low) - lines.begin()),
          int(std::lower_bound(lines.begin(), lines.end(), high) - lines.begin())};
}

}  // namespace

TEST_CASE("a box of columns four at a time is the box one by one, bit for bit") {
  Random random(21);
  std::size_t ofLarge = 0, ofSmall = 0, most = 0;
  for (int k = 0; k < 6000; ++k) {
    // Corners anywhere on the raster or in a small part of it, or on every n-th step, so that
    // columns meet edges and corners; some without area.
    // Sides just below and above 2^26, from which on integers are no longer floating-point numbers.
    const std::int32_t extents[] = {1 << 30, 1 << 24, (1 << 26) - 1, 1 << 26, 1 << 28};
    const std::int32_t extent = extents[k % 5], grain = k % 2 == 0 ? 1 : extent / 8;
    const auto place = [&] {
      return std::int32_t(random.uniform(0, 1.0 * extent / grain)) * grain;
    };
    SnappedMesh::Point p[3];
    // Sides as long as they can be, every third time.
    const auto at = [&] { return k % 3 == 0 ? extent * random.below(2) : place(); };
    for (auto& corner : p) corner = {at(), at(), random.uniform(-1, 1)};
    const Footprint footprint(p[0], p[1], p[2]);
    if (footprint.area == 0) continue;
    const int count = 3 + random.below(24);
    std::vector<std::int32_t> columns, rows;
    for (int i = 0; i < count; ++i) {
      columns.push_back(i % 7 == 0 ? p[i % 3].x : place());
      rows.push_back(i % 5 == 0 ? p[i % 3].y : place());
    }
    columns.front() = kBelow;
    columns[1] = 1 << 30;
    rows.back() = kAbove;
    std::sort(columns.begin(), columns.end());
    std::sort(rows.begin(), rows.end());
    const auto [left, right] = linesBetween(columns, std::min({p[0].x, p[1].x, p[2].x}),
                                            std::max({p[0].x, p[1].x, p[2].x}));
    const auto [low, high] =
        linesBetween(rows, std::min({p[0].y, p[1].y, p[2].y}), std::max({p[0].y, p[1].y, p[2].y}));
    columns.resize(columns.size() + kBoxStep, kAbove);
    const GridRaster raster{columns.data(), rows.data()};
    ColumnBox box{{left, low}, {right, high}};
    if (k % 4 < 2 && left < right && low < high) {
      box.first = {left + random.below(right - left), low + random.below(high - low)};
      box.last = {box.first.column + random.below(right - box.first.column + 1),
                  box.first.row + random.below(high - box.first.row + 1)};
    }
    RowHits wide(count, std::size_t(random.below(40))), plain(count, 100);
    castBox(footprint, raster, box, wide);
    castBoxPlainly(footprint, raster, box, plain);
    for (std::size_t row = 0; row < std::size_t(count); ++row) {
      const auto a = sorted(wide[row]), b = sorted(plain[row]);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].column == b[i].column);
        CHECK(a[i].sign == b[i].sign);
        CHECK(std::bit_cast<std::uint64_t>(a[i].depth) == std::bit_cast<std::uint64_t>(b[i].depth));
      }
      (extent >= 1 << 26 ? ofLarge : ofSmall) += a.size();
      most = std::max(most, a.size());
    }
  }
  CHECK(ofLarge > 10000);
  CHECK(ofSmall > 10000);
  CHECK(most > 10);
}
