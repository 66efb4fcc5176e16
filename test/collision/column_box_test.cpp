// Do the columns of large triangles, four at a time, equal the plain test bit for bit?
#include "collision/column_box.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <tuple>

#include "base/random.h"

using namespace resect;

namespace {

void keepSorted(std::vector<GridHit>& hits, const GridHit* end) {
  hits.resize(std::size_t(end - hits.data()));
  std::sort(hits.begin(), hits.end(),
            [](const GridHit& a, const GridHit& b) { return a.column < b.column; });
}

}  // namespace

TEST_CASE("a box of columns four at a time is the box one by one, bit for bit") {
  Random random(21);
  std::size_t covered = 0, most = 0;
  for (int k = 0; k < 3000; ++k) {
    // Corners anywhere on the raster, or on every n-th step of it, so that columns meet edges and
    // corners; some without area.
    const int grain = k % 2 == 0 ? 1 : 1 << 27;
    const auto place = [&] {
      return std::int32_t(random.uniform(0, 1.0 * (1 << 30) / grain)) * grain;
    };
    SnappedMesh::Point p[3];
    for (auto& corner : p) corner = {place(), place(), random.uniform(-1, 1)};
    const Footprint footprint(p[0], p[1], p[2]);
    if (footprint.area == 0) continue;
    const int count = 1 + random.below(24);
    std::vector<std::int32_t> columns, rows;
    for (int i = 0; i < count; ++i) {
      columns.push_back(i % 7 == 0 ? p[i % 3].x : place());
      rows.push_back(i % 5 == 0 ? p[i % 3].y : place());
    }
    columns.front() = kBelow;
    rows.back() = kAbove;
    std::sort(columns.begin(), columns.end());
    std::sort(rows.begin(), rows.end());
    columns.resize(columns.size() + kBoxStep, kAbove);
    const GridRaster raster{columns.data(), rows.data(), std::uint32_t(count)};
    GridCell first{0, 0}, last{count, count};
    if (k % 4 < 2) {
      first = {random.below(count), random.below(count)};
      last = {first.column + random.below(count - first.column + 1),
              first.row + random.below(count - first.row + 1)};
    }
    const std::size_t room =
        std::size_t(last.column - first.column) * std::size_t(last.row - first.row) + kBoxStep;
    std::vector<GridHit> wide(room), plain(room);
    const GridHit* wideEnd = castBox(footprint, raster, {first, last}, wide.data());
    const GridHit* plainEnd = castBoxPlainly(footprint, raster, {first, last}, plain.data());
    REQUIRE(wideEnd - wide.data() == plainEnd - plain.data());
    keepSorted(wide, wideEnd);
    keepSorted(plain, plainEnd);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      CHECK(wide[i].column == plain[i].column);
      CHECK(wide[i].sign == plain[i].sign);
      CHECK(std::bit_cast<std::uint64_t>(wide[i].depth) ==
            std::bit_cast<std::uint64_t>(plain[i].depth));
    }
    covered += wide.size();
    most = std::max(most, wide.size());
  }
  CHECK(covered > 10000);
  CHECK(most > 100);
}
