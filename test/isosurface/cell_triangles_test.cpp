#include "isosurface/cell_triangles.h"

#include <doctest/doctest.h>

#include <bit>
#include <vector>

#include "base/random.h"
#include "isosurface/marching_cubes_table.h"

using namespace resect;

namespace {

EdgeTable numbered() {
  EdgeTable table;
  for (std::size_t i = 0; i < table.vertex.size(); ++i) table.vertex[i] = 1000 + std::int32_t(i);
  return table;
}

CellKinds anyKinds(Random& random) {
  CellKinds kinds;
  for (std::uint8_t& kind : kinds) kind = std::uint8_t(random.below(256));
  return kinds;
}

}  // namespace

TEST_CASE("each edge that a brick's cells can use has a place of its own in the table") {
  std::vector<int> uses(EdgeTable::kNone, 0);
  for (int axis = 0; axis < 3; ++axis)
    for (int z = 0; z < EdgeTable::kSpan; ++z)
      for (int y = 0; y < EdgeTable::kSpan; ++y)
        for (int x = 0; x < EdgeTable::kSpan; ++x)
          ++uses[std::size_t(EdgeTable::index(axis, x, y, z))];
  for (const int n : uses) CHECK(n == 1);
}

TEST_CASE("a cell's edges are those between its corners") {
  for (int cell = 0; cell < kBrickSize; ++cell)
    for (int e = 0; e < 12; ++e) {
      const CellEdge edge = kCellEdges[std::size_t(e)];
      CHECK(EdgeTable::ofCell(cell, e) == EdgeTable::index(edge.axis, (cell & 3) + (edge.from & 1),
                                                           (cell >> 2 & 3) + (edge.from >> 1 & 1),
                                                           (cell >> 4) + (edge.from >> 2)));
    }
}

TEST_CASE(
    "triangles of any cells are those drawn edge by edge, and nothing lies beyond the limit") {
  Random random(5);
  const EdgeTable table = numbered();
  for (int round = 0; round < 500; ++round) {
    const CellKinds kinds = anyKinds(random);
    std::uint64_t cells = random.next();
    for (int thin = 0; thin < round % 5; ++thin) cells &= random.next();
    std::size_t count = 0;
    for (int cell = 0; cell < kBrickSize; ++cell)
      if (cells >> cell & 1) count += marchingCubesTable()[kinds[std::size_t(cell)]].count;
    std::vector<Triangle> plain(count), drawn(count + 8, Triangle{-1, -1, -1});
    const Triangle* plainEnd = drawCellsPlainly(table, kinds, cells, plain.data());
    REQUIRE(plainEnd == plain.data() + count);
    const std::size_t slack = std::size_t(random.below(8));
    const Triangle* limit = drawn.data() + count + slack;
    const Triangle* end = drawCells(table, kinds, cells, drawn.data(), limit);
    REQUIRE(end == drawn.data() + count);
    for (std::size_t t = 0; t < count; ++t) REQUIRE(drawn[t] == plain[t]);
    for (std::size_t t = count + slack; t < drawn.size(); ++t)
      REQUIRE(drawn[t] == Triangle{-1, -1, -1});
  }
}
