#include "wound/vertex_binding.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace resect {
namespace {

constexpr double kLeastWeight = 0.02;  // per axis: a particle on the vertex's side always counts

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

void normalise(VertexBinding& binding) {
  float sum = 0;
  for (const float weight : binding.weight) sum += weight;  // unused ones are 0
  for (float& weight : binding.weight) weight /= sum;
}

}  // namespace

VertexBinder::VertexBinder(const CutGrid& grid, const Lattice& lattice, int refine,
                           std::span<const std::uint8_t> particles)
    : grid_(grid), lattice_(lattice), refine_(refine), particles_(particles) {
  const Vec3i low = cubeAt(grid.first), high = cubeAt(grid.first + grid.dims);
  cubesInWindow_ = {low, high - low + Vec3i::Ones()};
  numberOfCube_.assign(cubesInWindow_.count(), -1);
  cubes_.reserve(27);
}

// A cube is identified by its lowest cell: the last whose centre lies at or before the organ's
// node, along each axis.
Vec3i VertexBinder::cubeAt(const Vec3i& node) const {
  return Vec3i(floorDiv(node.x(), refine_), floorDiv(node.y(), refine_),
               floorDiv(node.z(), refine_)) -
         Vec3i::Constant(2);
}

// Lattice cell k lies at the organ's node refine (k + 2).
std::int64_t VertexBinder::particleAt(const Vec3i& node) const {
  const Vec3i n = grid_.first + node;
  for (int a = 0; a < 3; ++a)
    if (n[a] < 0 || n[a] % refine_ != 0) return -1;
  return particleOf(n / refine_ - Vec3i::Constant(2));
}

std::int64_t VertexBinder::particleOf(const Vec3i& cell) const {
  if (!lattice_.contains(cell)) return -1;
  const std::int64_t i = lattice_.index(cell);
  return particles_[std::size_t(i)] ? i : -1;
}

double VertexBinder::weightAlong(double p, int node) const {
  return std::max(kLeastWeight, 1 - std::abs(p - node) / refine_);
}

void VertexBinder::add(VertexBinding& binding, double weight, std::int64_t cell) {
  if (binding.count < VertexBinding::kMost) {
    binding.cell[std::size_t(binding.count)] = std::int32_t(cell);
    binding.weight[std::size_t(binding.count++)] = float(weight);
    return;
  }
  const auto least = std::min_element(binding.weight.begin(), binding.weight.end());
  if (*least >= weight) return;
  *least = float(weight);
  binding.cell[std::size_t(least - binding.weight.begin())] = std::int32_t(cell);
}

template <typename Counts>
void VertexBinder::addCorners(VertexBinding& binding, const Cube& cube, const Vec3& p,
                              const Counts& counts) const {
  double weight[3][2];
  for (int a = 0; a < 3; ++a)
    for (const int end : {0, 1}) weight[a][end] = weightAlong(p[a], cube.low[a] + end * refine_);
  static_assert(VertexBinding::kMost == 8);
  for (int c = 0; c < 8; ++c) {
    if (cube.particle[std::size_t(c)] < 0 || !counts(c)) continue;
    const auto next = std::size_t(binding.count++);
    binding.cell[next] = std::int32_t(cube.particle[std::size_t(c)]);
    binding.weight[next] = float(weight[0][c & 1] * weight[1][c >> 1 & 1] * weight[2][c >> 2]);
  }
}

// Mask of the nodes of a cube, x fastest; at most 125, of a cube of four edges a side.
__extension__ typedef unsigned __int128 CubeNodes;

// Which nodes of the cube are inside, and from which a whole edge leads to the next node in the
// cube.
struct VertexBinder::CubeEdges {
  CubeNodes inside = 0;
  std::array<CubeNodes, 3> whole{};  // per axis
  bool unbroken = true;              // all nodes inside, all edges whole
};

VertexBinder::CubeEdges VertexBinder::edgesOf(const Vec3i& low) const {
  CubeEdges edges;
  const Vec3i end = low + Vec3i::Constant(refine_ + 1);
  CubeNodes bit = 1;
  for (int z = low.z(); z < end.z(); ++z)
    for (int y = low.y(); y < end.y(); ++y)
      for (int x = low.x(); x < end.x(); ++x, bit <<= 1) {
        const Vec3i n(x, y, z);
        if (!grid_.contains(n) || !grid_.inside(grid_.index(n))) {
          edges.unbroken = false;
          continue;
        }
        edges.inside |= bit;
        for (int a = 0; a < 3; ++a) {
          if (n[a] + 1 == end[a]) continue;
          if (grid_.whole(grid_.index(n), a))
            edges.whole[std::size_t(a)] |= bit;
          else
            edges.unbroken = false;
        }
      }
  return edges;
}

const VertexBinder::Cube& VertexBinder::cubeOf(const Vec3& p) {
  const Vec3i cell = cubeAt(grid_.first + p.array().floor().matrix().cast<int>());
  std::int32_t& number = numberOfCube_[std::size_t(cubesInWindow_.index(cell))];
  if (number >= 0) return cubes_[std::size_t(number)];
  number = std::int32_t(cubes_.size());
  Cube& made = cubes_.emplace_back();
  made.low = refine_ * (cell + Vec3i::Constant(2)) - grid_.first;
  for (int c = 0; c < 8; ++c)
    made.particle[std::size_t(c)] = particleOf(cell + Vec3i(c & 1, c >> 1 & 1, c >> 2));
  const CubeEdges edges = edgesOf(made.low);
  if (edges.unbroken)
    made.part.fill(0);
  else
    findParts(edges, made);
  const int side = refine_ + 1;
  for (int c = 0; c < 8; ++c)
    made.partOfCorner[std::size_t(c)] =
        made.part[std::size_t(refine_ * (((c >> 2) * side + (c >> 1 & 1)) * side + (c & 1)))];
  return made;
}

// Flood fill: a component grows from its first node by one edge in all directions at a time.
void VertexBinder::findParts(const CubeEdges& edges, Cube& made) const {
  const int side = refine_ + 1;
  const std::array<int, 3> step = {1, side, side * side};
  std::array<CubeNodes, 3> edge = edges.whole;  // with both ends in tissue
  for (std::size_t a = 0; a < 3; ++a) edge[a] &= edges.inside >> step[a];
  made.part.fill(kOutside);
  std::uint8_t parts = 0;
  for (CubeNodes left = edges.inside; left != 0; ++parts) {
    CubeNodes part = left & -left, before = 0;
    while (part != before) {
      before = part;
      for (std::size_t a = 0; a < 3; ++a)
        part |= (part & edge[a]) << step[a] | (part >> step[a] & edge[a]);
    }
    left &= ~part;
    for (std::size_t i = 0; part != 0; ++i, part >>= 1)
      if (part & 1) made.part[i] = parts;
  }
}

VertexBinding VertexBinder::bindWithin(const Vec3& p, const Vec3i& place, NearbyNodes anchors) {
  const Cube& within = cubeOf(p);
  const Vec3i& low = within.low;
  const int side = refine_ + 1;
  std::bitset<kOutside + 1> wanted;  // components of the cube
  visitNearby(anchors, [&](const Vec3i& offset) {
    const Vec3i d = place + offset - low;
    if ((d.array() >= 0).all() && (d.array() < side).all())
      wanted.set(within.part[std::size_t((d.z() * side + d.y()) * side + d.x())]);
  });
  wanted.reset(kOutside);
  VertexBinding binding;
  addCorners(binding, within, p,
             [&](int c) { return wanted[within.partOfCorner[std::size_t(c)]]; });
  if (binding.count > 0) normalise(binding);
  return binding;
}

VertexBinding VertexBinder::bind(const Vec3& p, const Vec3i& place, NearbyNodes anchors) {
  VertexBinding binding = bindWithin(p, place, anchors);
  if (binding.count > 0) return binding;
  lookedFar_ = true;
  binding = bindWidely(p, place, anchors);
  if (binding.count == 0) binding = bindToNearest(p);
  if (binding.count > 0) normalise(binding);
  return binding;
}

// The particles fewest whole edges away from the anchors, and those one edge farther: a wider
// search would reach the other side round the front of a cut.
VertexBinding VertexBinder::bindWidely(const Vec3& p, const Vec3i& place,
                                       NearbyNodes anchors) const {
  VertexBinding binding;
  constexpr std::size_t kMostNodes = 729;  // of a brick's window
  require(std::size_t(grid_.dims.prod()) <= kMostNodes,
          "a window of {} nodes was given, more than {}; give that of one brick", grid_.dims.prod(),
          kMostNodes);
  std::bitset<kMostNodes> seen;
  std::array<std::int16_t, kMostNodes> queue;
  std::size_t count = 0, layerEnd = 0;
  int layersLeft = std::numeric_limits<int>::max();
  const auto visit = [&](const Vec3i& n) {
    if (!grid_.contains(n)) return;
    const int i = grid_.index(n);
    if (!grid_.inside(i) || seen[std::size_t(i)]) return;
    seen.set(std::size_t(i));
    queue[count++] = std::int16_t(i);
  };
  visitNearby(anchors, [&](const Vec3i& offset) { visit(place + offset); });
  layerEnd = count;
  for (std::size_t at = 0; at < count; ++at) {
    if (at == layerEnd) {
      layerEnd = count;
      if (binding.count > 0) layersLeft = std::min(layersLeft, 2) - 1;
      if (layersLeft == 0) break;
    }
    const int i = queue[at];
    const Vec3i n = grid_.node(i);
    const std::int64_t cell = particleAt(n);
    if (cell >= 0)
      add(binding,
          weightAlong(p.x(), n.x()) * weightAlong(p.y(), n.y()) * weightAlong(p.z(), n.z()), cell);
    for (int a = 0; a < 3; ++a) {
      if (n[a] + 1 < grid_.dims[a] && grid_.whole(i, a)) visit(n + Vec3i::Unit(a));
      if (n[a] > 0 && grid_.whole(i - grid_.stride(a), a)) visit(n - Vec3i::Unit(a));
    }
  }
  return binding;
}

// A piece without a particle follows the nearest one, even across a cut.
VertexBinding VertexBinder::bindToNearest(const Vec3& p) const {
  VertexBinding binding;
  const Vec3 at = (p + grid_.first.cast<double>()) / refine_ - Vec3::Constant(2);  // cells
  const Vec3i middle = at.array().round().matrix().cast<int>();
  double nearest = std::numeric_limits<double>::infinity();
  for (int z = -2; z <= 2; ++z)
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) {
        const Vec3i cell = middle + Vec3i(x, y, z);
        if (!lattice_.contains(cell) || !particles_[std::size_t(lattice_.index(cell))]) continue;
        const double distance = (cell.cast<double>() - at).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        binding.count = 1;
        binding.cell[0] = std::int32_t(lattice_.index(cell));
        binding.weight[0] = 1;
      }
  return binding;
}

}  // namespace resect
