#include "anatomy/thinning/skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

namespace resect {
namespace {

constexpr double kCovered = 1.6;    // depths round a way that are done with
constexpr double kEnd = 1.5;        // depths: how far from its end a vessel's middle is found
constexpr double kBulge = 2.0;      // depths: what ends nearer to the vessel it leaves is none
constexpr double kRoughness = 1.5;  // cells: and so much beyond, for walls are rough

// A connected part of the shape, its cells numbered from 0.
struct Part {
  const SolidShape& shape;
  std::vector<std::int64_t> cells;
  std::vector<std::int32_t>&
      numbers;  // per cell of the lattice: its number in its part; -1 outside

  double depth(int number) const { return shape.depth[std::size_t(cells[std::size_t(number)])]; }
  Vec3i cell(int number) const { return shape.lattice.cell(cells[std::size_t(number)]); }

  // Calls visit(number, distance in cells) for the neighbours inside, of 26.
  template <typename Visit>
  void visitNeighbours(int number, Visit visit) const {
    const Vec3i at = cell(number);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const Vec3i next = at + Vec3i(x, y, z);
          if ((x == 0 && y == 0 && z == 0) || !shape.lattice.contains(next)) continue;
          const std::int32_t n = numbers[std::size_t(shape.lattice.index(next))];
          if (n >= 0) visit(int(n), std::sqrt(double(x * x + y * y + z * z)));
        }
  }
};

// The way from each cell of a part to a root, in the middle of the shape.
struct Ways {
  std::vector<int> parent;     // next cell towards the root; -1 at the root
  std::vector<double> length;  // to the root, cells
};

Ways waysTo(const Part& part, int root) {
  const std::size_t count = part.cells.size();
  double deepest = 0;
  for (int i = 0; i < int(count); ++i) deepest = std::max(deepest, part.depth(i));
  Ways ways{std::vector<int>(count, -1), std::vector<double>(count, 0)};
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[std::size_t(root)] = 0;
  open.push({0, root});
  while (!open.empty()) {
    const auto [reached, at] = open.top();
    open.pop();
    if (reached > cost[std::size_t(at)]) continue;
    part.visitNeighbours(at, [&](int next, double distance) {
      const double narrow = 2 * deepest / (part.depth(at) + part.depth(next));
      const double there = reached + distance * narrow * narrow;
      if (there >= cost[std::size_t(next)]) return;
      cost[std::size_t(next)] = there;
      ways.parent[std::size_t(next)] = at;
      ways.length[std::size_t(next)] = ways.length[std::size_t(at)] + distance;
      open.push({there, next});
    });
  }
  return ways;
}

// Marks the cells of the part within the radius (m) of a cell.
void cover(const Part& part, int number, double radius, std::vector<char>& covered) {
  const Lattice& lattice = part.shape.lattice;
  const int reach = int(radius / part.shape.cell());
  const Vec3i at = part.cell(number);
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const Vec3i next = at + Vec3i(x, y, z);
        if (!lattice.contains(next) || x * x + y * y + z * z > reach * reach) continue;
        const std::int32_t n = part.numbers[std::size_t(lattice.index(next))];
        if (n >= 0) covered[std::size_t(n)] = 1;
      }
}

// The first cell of a way from a vessel's end that lies deeper inside than the end is wide.
std::size_t middleFrom(const Part& part, const std::vector<int>& way) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double off =
        part.shape.cell() * (part.cell(way[i]) - part.cell(way[0])).cast<double>().norm();
    if (off < kEnd * part.depth(way[i])) first = i + 1;
  }
  return std::min(first, way.size() - 1);
}

struct Tree {
  std::vector<int> cells, parents;  // as in Skeleton, with the part's numbers
  std::vector<int> ends;            // index in `cells` of the ways' ends
};

Tree treeFrom(const Part& part, int root) {
  const Ways ways = waysTo(part, root);
  std::vector<int> farthest(part.cells.size());
  for (std::size_t i = 0; i < farthest.size(); ++i) farthest[i] = int(i);
  std::ranges::stable_sort(farthest, std::greater<>(),
                           [&](int i) { return ways.length[std::size_t(i)]; });
  Tree tree{{root}, {-1}, {}};
  std::vector<int> place(part.cells.size(), -1);  // in the tree
  place[std::size_t(root)] = 0;
  std::vector<char> covered(part.cells.size(), 0);
  const double rough = kRoughness * part.shape.cell();
  cover(part, root, kCovered * part.depth(root) + rough, covered);
  for (const int end : farthest) {
    if (covered[std::size_t(end)]) continue;
    std::vector<int> way;  // from the end to the tree
    int at = end;
    for (; place[std::size_t(at)] < 0; at = ways.parent[std::size_t(at)]) way.push_back(at);
    const double beyond =
        (ways.length[std::size_t(end)] - ways.length[std::size_t(at)]) * part.shape.cell();
    // What hardly leaves the vessel that it comes from is a bulge of its wall.
    const bool bulge = beyond < kBulge * part.depth(at) + 2 * rough;
    for (const int cell : way) cover(part, cell, kCovered * part.depth(cell) + rough, covered);
    if (bulge) continue;
    // The end is some corner of the vessel's end: the way is taken back to where it runs in the
    // middle.
    const auto first = std::ptrdiff_t(middleFrom(part, way));
    for (auto cell = way.rbegin(); cell != way.rend() - first; ++cell) {
      tree.parents.push_back(place[std::size_t(at)]);
      place[std::size_t(*cell)] = int(tree.cells.size());
      tree.cells.push_back(*cell);
      at = *cell;
    }
    tree.ends.push_back(int(tree.cells.size()) - 1);
  }
  return tree;
}

// The end of the widest vessel.
int rootOf(const Part& part) {
  int deepest = 0;
  for (int i = 1; i < int(part.cells.size()); ++i)
    if (part.depth(i) > part.depth(deepest)) deepest = i;
  const Tree tree = treeFrom(part, deepest);
  if (tree.ends.empty()) return deepest;
  const int widest = *std::ranges::max_element(
      tree.ends, {}, [&](int end) { return part.depth(tree.cells[std::size_t(end)]); });
  return tree.cells[std::size_t(widest)];
}

}  // namespace

std::vector<Skeleton> skeletons(const SolidShape& shape) {
  std::vector<Skeleton> all;
  std::vector<std::int32_t> numbers(shape.depth.size(), -1);
  std::vector<char> seen(shape.depth.size(), 0);
  for (std::size_t first = 0; first < shape.depth.size(); ++first) {
    if (seen[first] || !(shape.depth[first] > 0)) continue;
    Part part{shape, {std::int64_t(first)}, numbers};
    seen[first] = 1;
    double deepest = 0;
    for (std::size_t i = 0; i < part.cells.size(); ++i) {
      deepest = std::max(deepest, part.depth(int(i)));
      const Vec3i at = part.cell(int(i));
      visitCellsIn(
          shape.lattice,
          {shape.lattice.centre(at - Vec3i::Ones()), shape.lattice.centre(at + Vec3i::Ones())},
          [&](const Vec3i& next) {
            const std::int64_t cell = shape.lattice.index(next);
            if (seen[std::size_t(cell)] || !(shape.depth[std::size_t(cell)] > 0)) return;
            seen[std::size_t(cell)] = 1;
            part.cells.push_back(cell);
          });
    }
    if (deepest <= shape.cell()) continue;
    for (std::size_t i = 0; i < part.cells.size(); ++i)
      numbers[std::size_t(part.cells[i])] = std::int32_t(i);
    const Tree tree = treeFrom(part, rootOf(part));
    Skeleton skeleton;
    for (const int number : tree.cells) skeleton.cells.push_back(part.cells[std::size_t(number)]);
    skeleton.parents = tree.parents;
    if (skeleton.cells.size() > 1) all.push_back(std::move(skeleton));
    for (const std::int64_t cell : part.cells) numbers[std::size_t(cell)] = -1;
  }
  return all;
}

namespace {

// Cells of the tree that have at most one neighbour in it.
std::vector<int> endsOf(const Skeleton& tree) {
  std::vector<int> neighbours(tree.cells.size(), 0);
  for (std::size_t i = 1; i < tree.cells.size(); ++i)
    ++neighbours[i], ++neighbours[std::size_t(tree.parents[i])];
  std::vector<int> ends;
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    if (neighbours[i] <= 1) ends.push_back(int(i));
  return ends;
}

// The same tree, seen from another of its cells.
Skeleton rootedAt(const Skeleton& tree, int root) {
  std::vector<std::vector<int>> beside(tree.cells.size());
  for (std::size_t i = 1; i < tree.cells.size(); ++i) {
    beside[i].push_back(tree.parents[i]);
    beside[std::size_t(tree.parents[i])].push_back(int(i));
  }
  Skeleton turned;
  turned.cells = {tree.cells[std::size_t(root)]};
  turned.parents = {-1};
  std::vector<int> from{root}, before{-1};
  for (std::size_t k = 0; k < from.size(); ++k)
    for (const int next : beside[std::size_t(from[k])]) {
      if (next == before[k]) continue;
      from.push_back(next), before.push_back(from[k]);
      turned.cells.push_back(tree.cells[std::size_t(next)]);
      turned.parents.push_back(int(k));
    }
  return turned;
}

}  // namespace

void rootTogether(const SolidShape& shape, std::vector<Skeleton>& trees) {
  if (trees.size() < 2) return;
  const auto placeOf = [&](const Skeleton& tree, int cell) -> Vec3 {
    return shape.lattice.centre(shape.lattice.cell(tree.cells[std::size_t(cell)]));
  };
  std::size_t longest = 0;
  for (const Skeleton& tree : trees) longest = std::max(longest, tree.cells.size());
  const auto nearestEnd = [&](const Skeleton& tree, const Vec3& place) {
    const std::vector<int> ends = endsOf(tree);
    return *std::ranges::min_element(ends, {},
                                     [&](int end) { return (placeOf(tree, end) - place).norm(); });
  };
  std::optional<Vec3> meeting;
  double least = 0;
  for (const Skeleton& tree : trees) {
    if (5 * tree.cells.size() < longest) continue;
    for (const int end : endsOf(tree)) {
      const Vec3 place = placeOf(tree, end);
      double sum = 0;
      for (const Skeleton& other : trees)
        if (5 * other.cells.size() >= longest)
          sum += (placeOf(other, nearestEnd(other, place)) - place).norm();
      if (!meeting || sum < least) least = sum, meeting = place;
    }
  }
  for (Skeleton& tree : trees) tree = rootedAt(tree, nearestEnd(tree, *meeting));
}

}  // namespace resect
