// Vertices follow only particles on their own side of every cut.
#include "wound/vertex_binding.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

#include "base/random.h"

using namespace resect;

namespace {

constexpr int kSide = 9;  // of a brick's window

// Tissue with holes in which edges are severed at random.
struct Window {
  std::vector<float> value = std::vector<float>(kSide * kSide * kSide, 0.0f);
  std::array<std::vector<float>, 3> severed;
  CutGrid grid;

  Window(Random& random, int refine) {
    const double tissue = random.uniform(0.6, 1), cut = random.uniform(0, 0.5);
    for (float& v : value) v = random.uniform() < tissue ? 100.0f : 0.0f;
    for (auto& along : severed) {
      along.assign(value.size(), kWhole);
      for (float& share : along)
        if (random.uniform() < cut) share = 0.5f;
    }
    grid.first = Vec3i::Constant(4 * refine);
    grid.dims = Vec3i::Constant(kSide);
    grid.value = value.data();
    grid.severed = {severed[0].data(), severed[1].data(), severed[2].data()};
  }
};

// The nodes that whole edges through tissue lead to from `node` without leaving the cube.
std::set<int> connected(const CutGrid& grid, const Vec3i& node, const Vec3i& low, int refine) {
  const auto open = [&](const Vec3i& n) {
    return ((n - low).array() >= 0).all() && ((n - low).array() <= refine).all() &&
           grid.contains(n) && grid.inside(grid.index(n));
  };
  std::set<int> seen = {grid.index(node)};
  std::vector<Vec3i> left = {node};
  while (!left.empty()) {
    const Vec3i n = left.back();
    left.pop_back();
    for (int a = 0; a < 3; ++a)
      for (const int way : {-1, 1}) {
        const Vec3i to = n + way * Vec3i::Unit(a);
        const Vec3i lower = way > 0 ? n : to;
        if (open(to) && grid.whole(grid.index(lower), a) && seen.insert(grid.index(to)).second)
          left.push_back(to);
      }
  }
  return seen;
}

}  // namespace

TEST_CASE("a node follows the particles that whole edges of its cube lead to, and no other") {
  Random random(3);
  int checked = 0, partial = 0;
  for (int k = 0; k < 200; ++k) {
    const int refine = 1 + k % 4;
    const Window window(random, refine);
    const CutGrid& grid = window.grid;
    Lattice lattice;
    lattice.spacing = Vec3::Constant(0.005);
    lattice.dims = Vec3i::Constant(20);
    const std::vector<std::uint8_t> particles(std::size_t(lattice.cellCount()), 1);
    VertexBinder binder(grid, lattice, refine, particles);
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const Vec3i n = grid.node(i);
      const Vec3i low = (n / refine) * refine;  // the window's first node is one of the lattice's
      if (!grid.inside(i) || !grid.contains(low + Vec3i::Constant(refine))) continue;
      const std::set<int> part = connected(grid, n, low, refine);
      std::set<std::int32_t> expected;
      for (int c = 0; c < 8; ++c) {
        const Vec3i corner = low + refine * Vec3i(c & 1, c >> 1 & 1, c >> 2);
        if (part.count(grid.index(corner)))
          expected.insert(
              std::int32_t(lattice.index((grid.first + corner) / refine - Vec3i::Constant(2))));
      }
      if (expected.empty()) continue;  // a wider search is left to the wound's tests
      const VertexBinding binding = binder.bind(n.cast<double>(), n, nearbyNode(0, 0, 0));
      CHECK(std::set(binding.cell.begin(), binding.cell.begin() + binding.count) == expected);
      ++checked;
      partial += expected.size() < 8;
    }
  }
  CHECK(checked > 20000);
  CHECK(partial > 5000);
}
