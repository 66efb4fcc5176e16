#include "isosurface/cell_kinds.h"

#include <doctest/doctest.h>

#include <bit>

#include "base/random.h"
#include "isosurface/marching_cubes_table.h"

using namespace resect;

namespace {

std::uint64_t anyMask(Random& random) {
  std::uint64_t mask = 0;
  for (int bit = 0; bit < 64; ++bit) mask |= std::uint64_t(random.below(2)) << bit;
  return mask;
}

// Is node (x, y, z), each 0 to 4, inside, given the masks of a brick and its neighbours above?
bool inside(const std::array<std::uint64_t, 8>& masks, int x, int y, int z) {
  const int neighbour = x / 4 + y / 4 * 2 + z / 4 * 4, node = x % 4 + y % 4 * 4 + z % 4 * 16;
  return masks[std::size_t(neighbour)] >> node & 1;
}

}  // namespace

TEST_CASE("the nodes inside are those with at least the iso value") {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    std::array<float, kBrickSize> nodes;
    for (float& v : nodes) v = random.below(4) == 0 ? 50.f : float(random.uniform(0, 100));
    const std::uint64_t mask = insideMask(nodes, 50);
    for (std::size_t n = 0; n < kBrickSize; ++n) CHECK((mask >> n & 1) == (nodes[n] >= 50));
  }
}

TEST_CASE("the kinds of a brick's cells are the corners found one by one") {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    std::array<std::uint64_t, 8> masks;
    for (std::uint64_t& mask : masks)
      mask = round % 3 == 0 ? anyMask(random) & anyMask(random) & anyMask(random) : anyMask(random);
    const auto corners = cornerMasks(masks);
    const CellKinds kinds = cellKinds(corners);
    std::uint64_t crossed = 0;
    int triangles = 0;
    for (int cell = 0; cell < kBrickSize; ++cell) {
      int kind = 0;
      for (int c = 0; c < 8; ++c)
        kind |= inside(masks, (cell & 3) + (c & 1), (cell >> 2 & 3) + (c >> 1 & 1),
                       (cell >> 4) + (c >> 2))
                << c;
      REQUIRE(kinds[std::size_t(cell)] == kind);
      crossed |= std::uint64_t(kind != 0 && kind != 255) << cell;
      triangles += marchingCubesTable()[std::size_t(kind)].count;
    }
    CHECK(crossedCells(corners) == crossed);
    CHECK(countTriangles(corners, crossed) == triangles);
    CHECK(countTriangles(corners, 0) == 0);
  }
}

TEST_CASE("triangles of every kind of cell are counted as marching cubes draws them") {
  for (unsigned first = 0; first < 256; first += 64) {
    std::array<std::uint64_t, 8> corners{};  // cell c is of kind first + c
    for (unsigned cell = 0; cell < 64; ++cell)
      for (unsigned corner = 0; corner < 8; ++corner)
        corners[corner] |= std::uint64_t((first + cell) >> corner & 1) << cell;
    for (unsigned cell = 0; cell < 64; ++cell)
      CHECK(countTriangles(corners, crossedCells(corners) & std::uint64_t(1) << cell) ==
            marchingCubesTable()[first + cell].count);
  }
}
