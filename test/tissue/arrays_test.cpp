// Search for cells, and alignment of arrays.
#include <doctest/doctest.h>

#include <cstdint>
#include <set>

#include "support/tissue_blocks.h"
#include "tissue/elastic/chunk_bounds.h"

using namespace resect;
using test::material;
using test::solidBlock;

namespace {

// A block with holes, longer than two chunks, bent and stretched.
ElasticTissue bentBlock(Random& random) {
  TissueCells cells = solidBlock({37, 7, 6}, 0.004, material(5000, 0.45));
  cells.lattice.origin = Vec3(-0.03, 0.01, 0.2);
  for (std::uint8_t& solid : cells.solid) solid = random.uniform() > 0.3;
  ElasticTissue tissue(cells, {});
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    const double x = 0.004 * at.x();
    tissue.setDisplacement(c, {0.4 * x, 0.03 * std::sin(30 * x), 0.002 * random.uniform(-1, 1)});
    tissue.setVelocity(c, Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 2)));
  });
  return tissue;
}

}  // namespace

TEST_CASE("cells in a box are those whose centres are in it") {
  Random random(5);
  const ElasticTissue tissue = bentBlock(random);
  const Lattice& lattice = tissue.lattice();
  const Aabb all = {{-0.04, -0.03, 0.19}, {0.2, 0.08, 0.24}};
  std::size_t found = 0;
  for (int k = 0; k < 300; ++k) {
    Aabb box;
    for (int corner = 0; corner < 2; ++corner)
      box.grow({random.uniform(all.min.x(), all.max.x()), random.uniform(all.min.y(), all.max.y()),
                random.uniform(all.min.z(), all.max.z())});
    std::vector<std::int64_t> expected;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (box.contains(lattice.centre(at) + tissue.displacement(c))) expected.push_back(c);
    });
    CHECK(tissue.cellsIn(box) == expected);
    found += expected.size();
  }
  CHECK(found > 1000);
  CHECK(tissue.cellsIn({}).empty());
}

TEST_CASE("a chunk's bounds hold its cells, and none is faster than it is said to be") {
  Random random(6);
  const ElasticTissue tissue = bentBlock(random);
  const ElasticState& s = tissue.state();
  for (const TissueChunk& chunk : s.chunks) {
    const Aabb box = chunkBounds(s, chunk, tissue.lattice().origin);
    const double speed = chunkSpeed(s, chunk);
    Aabb cells;
    double fastest = 0;
    for (int k = 0; k < kChunk; ++k) {
      if (!s.solid[chunk.start + k]) continue;
      const std::int64_t c = s.box.toLattice(chunk.start + k);
      const Vec3 x = tissue.lattice().centre(tissue.lattice().cell(c)) + tissue.displacement(c);
      CHECK(box.contains(x));
      cells.grow(x);
      fastest = std::max(fastest, tissue.velocity(c).norm());
    }
    CHECK(speed >= fastest);
    CHECK(speed < 1.00001 * fastest);
    // Along x at most as much wider as its cells are moved apart, across at most their shift.
    CHECK((box.size() - cells.size()).maxCoeff() < 0.07);
  }
}

TEST_CASE("large arrays start on a line of their own in a page, small ones anywhere on a line") {
  constexpr std::size_t kArrays = 40;
  std::vector<AlignedArray<float>> arrays;
  std::set<std::size_t> lines;
  for (std::size_t k = 0; k < kArrays; ++k) {
    AlignedArray<float>& array = arrays.emplace_back(40000 + k, float(k));
    const auto address = reinterpret_cast<std::uintptr_t>(array.data());
    CHECK(address % kCacheLine == 0);
    lines.insert(address % kPage);
    array.push_back(1);  // into another block
    CHECK(array.front() == float(k));
    CHECK(array[39999] == float(k));
  }
  CHECK(lines.size() > kArrays / 2);
  const AlignedArray<double> small(100, 3.0);
  CHECK(reinterpret_cast<std::uintptr_t>(small.data()) % kCacheLine == 0);
}
