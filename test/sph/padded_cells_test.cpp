// Padded cells keep their values, and occupancy masks agree with them.
#include "sph/padded_cells.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "base/random.h"
#include "support/block_organ.h"

using namespace resect;

namespace {

// Random levels, half of them empty or full.
Discretization randomLevels(const Vec3i& dims, std::uint64_t seed) {
  Discretization d = test::noise(dims, seed);
  Random random(seed);
  ColourValues values(d.value.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int kind = random.below(4);
    values.set(i, kind == 0 ? 0.f : kind == 1 ? 100.f : kLevel * std::floor(d.value[i] / kLevel));
  }
  d.value = std::move(values);
  return d;
}

// Of a place beside the lattice too: 0.
float valueAt(const Discretization& d, const Vec3i& cell) {
  if ((cell.array() < 0).any() || (cell.array() >= d.lattice.dims.array()).any()) return 0;
  return d.value[std::size_t(d.lattice.index(cell))];
}

void checkAll(const Discretization& d) {
  HeldBits held;
  const PaddedCells cells(d, held);
  std::int64_t wrong = 0, row = 0;
  for (int z = 0; z < cells.dims().z(); ++z)
    for (int y = 0; y < cells.dims().y(); ++y, ++row)
      for (int x = 0; x < int(held.words * HeldBits::kWord); ++x) {
        const Vec3i cell = Vec3i(x, y, z) - Vec3i::Constant(PaddedCells::kBelow);
        const float value = valueAt(d, cell);
        const std::uint64_t* bits = held.bits.data() + std::size_t(row) * held.row;
        const auto bit = [&](std::size_t first) {
          return (bits[first + std::size_t(x) / 64] >> x % 64 & 1) != 0;
        };
        if (x < cells.dims().x()) wrong += cells.value(cells.index(cell)) != value;
        wrong += bit(0) != (value > 0);
        wrong += bit(held.words) != (value == 100);
      }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("cells, the empty ones round them and what they hold, in rows of any length") {
  for (const int across : {1, 2, 31, 32, 33, 54, 55, 61, 64, 118, 131, 200}) {
    CAPTURE(across);
    Discretization d = randomLevels({across, 3, 7}, std::uint64_t(across));
    for (const int threads : {1, 3}) {
      const ThreadLimit limit(threads);
      checkAll(d);
    }
    d.value.set(d.value.size() - 1, 33.3f);  // as numbers
    checkAll(d);
  }
}

TEST_CASE("a lattice without cells is all empty ones") {
  for (const Vec3i& dims : {Vec3i(0, 3, 7), Vec3i(5, 0, 2), Vec3i(5, 4, 0)}) {
    Discretization d = randomLevels({1, 1, 1}, 1);
    d.lattice.dims = dims;
    d.value = {};
    checkAll(d);
  }
}

TEST_CASE("cells that are set hold it, and how they are held changes no value") {
  Discretization d = randomLevels({9, 5, 6}, 7);
  HeldBits held;
  PaddedCells cells(d, held);
  const std::size_t asLevels = cells.bytes();
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const auto i = std::int64_t(random.below(int(d.value.size())));
    // From half way on any number.
    const float value = k < 50 ? kLevel * float(random.below(129)) : float(random.below(1000)) / 10;
    d.value.set(std::size_t(i), value);
    cells.set(cells.index(d.lattice.cell(i)), value);
    if (k == 49) CHECK(cells.bytes() == asLevels);
  }
  CHECK(cells.bytes() > 3 * asLevels);
  CHECK(cells.bytes() <= 4 * asLevels + 4);  // what was held as levels is given back
  HeldBits again;
  CHECK(PaddedCells(d, again).bytes() <= 4 * asLevels + 4);
  for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i)
    REQUIRE(cells.value(cells.index(d.lattice.cell(i))) == d.value[std::size_t(i)]);
}

TEST_CASE("a box of cells holds nothing, all it can, or neither") {
  for (const float other : {kLevel, 33.3f}) {
    Discretization d = randomLevels({6, 6, 6}, 1);
    for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i) {
      const Vec3i c = d.lattice.cell(i);
      d.value.set(std::size_t(i), c.x() < 3 ? 0.f : 100.f);
    }
    d.value.set(std::size_t(d.lattice.index({5, 5, 5})), other);
    HeldBits held;
    const PaddedCells cells(d, held);
    using Held = PaddedCells::Held;
    CHECK(cells.heldIn({0, 0, 0}, {3, 6, 6}) == Held::Nothing);
    CHECK(cells.heldIn({-3, -3, -3}, {6, 4, 4}) == Held::Nothing);
    CHECK(cells.heldIn({3, 0, 0}, {3, 6, 5}) == Held::All);
    CHECK(cells.heldIn({3, 0, 0}, {3, 6, 6}) == Held::Mixed);
    CHECK(cells.heldIn({2, 0, 0}, {3, 3, 3}) == Held::Mixed);
    CHECK(cells.heldIn({3, 0, 0}, {4, 3, 3}) == Held::Mixed);
  }
}
