#include "surface/brick_mesher.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/instruction_set.h"

namespace resect {
namespace {

// Nodes -1 to 5 of a brick along each axis, x fastest: all that its vertices and their normals
// depend on. A row takes eight places, so that it starts where a vector may.
constexpr int kHalo = 7, kHaloRow = 8;
using Halo = std::array<float, kHalo * kHalo * kHaloRow>;
constexpr int kStep[3] = {1, kHaloRow, kHalo* kHaloRow};

// Place in the halo of the brick's node (x, y, z), each -1 to 5.
constexpr int at(int x, int y, int z) { return ((z + 1) * kHalo + y + 1) * kHaloRow + x + 1; }

// The same of its 64 nodes by number.
constexpr std::array<std::int32_t, kBrickSize> kPlaceOf = [] {
  std::array<std::int32_t, kBrickSize> places{};
  for (int n = 0; n < kBrickSize; ++n) places[std::size_t(n)] = at(n & 3, n >> 2 & 3, n >> 4);
  return places;
}();

// Nodes of the bricks beside a brick along x, and of itself.
struct BrickRow {
  const float *left, *middle, *right;
};

// The rows of the halo that lie in the bricks kY, kZ (-1 to 1) from the middle: of each the last
// node of the brick to the left, all four of the middle, the first two of the brick to the right.
template <int kY, int kZ>
[[gnu::always_inline]] inline void copyRows(const BrickRow& bricks, Halo& halo) {
  // Along an axis the neighbour below gives its last node, the one above its first two.
  constexpr int kFirst[3] = {kBrickNodes - 1, 0, 0}, kEnd[3] = {kBrickNodes, kBrickNodes, 2};
#pragma GCC unroll 4
  for (int z = kFirst[kZ + 1]; z < kEnd[kZ + 1]; ++z)
#pragma GCC unroll 4
    for (int y = kFirst[kY + 1]; y < kEnd[kY + 1]; ++y) {
      const int row = (z * kBrickNodes + y) * kBrickNodes;
      float* out = &halo[at(0, kBrickNodes * kY + y, kBrickNodes * kZ + z)];
      std::memcpy(out, bricks.middle + row, kBrickNodes * sizeof(float));
      if (kY != 0 && kZ != 0) continue;  // no vertex and no normal depends on a corner
      out[-1] = bricks.left[row + kBrickNodes - 1];
      std::memcpy(out + kBrickNodes, bricks.right + row, 2 * sizeof(float));
    }
}

// The bricks round a brick, by row: [z][y] from -1 on. nodesOf(x, y, z) gives one of them.
template <typename NodesOf>
[[gnu::always_inline]] inline void findRows(BrickRow (&rows)[3][3], NodesOf nodesOf) {
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y) {
      BrickRow& row = rows[z + 1][y + 1];
      row.middle = nodesOf(0, y, z);
      if (y != 0 && z != 0) continue;
      row.left = nodesOf(-1, y, z);
      row.right = nodesOf(1, y, z);
    }
}

// The values of the nodes of the halo; 0 outside the grid. Nodes that differ from the brick along
// all three axes are left out.
void gatherHalo(const ColourField& field, const Vec3i& brick, Halo& halo) {
  static constexpr float kOutside[kBrickSize] = {};
  const Vec3i dims = field.brickDims(), last = dims - Vec3i::Ones();
  const std::int64_t index = field.brickIndex(brick), alongY = dims.x(), alongZ = alongY * dims.y();
  const auto nodesAt = [&](int x, int y, int z) {
    return field.nodes(index + x + y * alongY + z * alongZ);
  };
  BrickRow around[3][3];
  if ((brick.array() > 0).all() && (brick.array() < last.array()).all())
    findRows(around, nodesAt);
  else
    findRows(around, [&](int x, int y, int z) {
      const Vec3i b = brick + Vec3i(x, y, z);
      const bool exists = (b.array() >= 0).all() && (b.array() <= last.array()).all();
      return exists ? nodesAt(x, y, z) : kOutside;
    });
  copyRows<-1, -1>(around[0][0], halo);
  copyRows<0, -1>(around[0][1], halo);
  copyRows<1, -1>(around[0][2], halo);
  copyRows<-1, 0>(around[1][0], halo);
  copyRows<0, 0>(around[1][1], halo);
  copyRows<1, 0>(around[1][2], halo);
  copyRows<-1, 1>(around[2][0], halo);
  copyRows<0, 1>(around[2][1], halo);
  copyRows<1, 1>(around[2][2], halo);
}

// Vertices keep this share of an edge away from its ends, so that no two of them fall together.
constexpr float kEndMargin = 1e-3f;
// Colour values below the iso level of the original field over which skin turns into cut
// parenchyma.
constexpr float kCutRange = 15;

// Numbers of four vertices.
typedef float Four __attribute__((vector_size(16)));
typedef float Two __attribute__((vector_size(8)));

// The crossed edges of a brick, number by number; up to the next multiple of four, edges that count
// for nothing.
struct CrossedEdges {
  static constexpr int kMost = 3 * kBrickSize;
  int count = 0;
  std::array<std::uint8_t, kMost> node;       // the lower end, 0 to 63
  std::array<std::int32_t, kMost> low, high;  // places of both ends in the halo
  std::array<float, kMost> way;               // of the vertex along the edge, 0 to 1

  template <int kAxis>
  [[gnu::always_inline]] void add(std::uint64_t crossing) {
    for (; crossing != 0; crossing &= crossing - 1) {
      const int n = std::countr_zero(crossing);
      const auto i = std::size_t(count++);
      node[i] = std::uint8_t(n);
      low[i] = kPlaceOf[std::size_t(n)];
      high[i] = kPlaceOf[std::size_t(n)] + kStep[kAxis];
    }
  }
  void fillUp() {
    for (auto i = std::size_t(count); i % 4 != 0; ++i) low[i] = high[i] = at(0, 0, 0);
  }
};

// Where four edges cross the iso level, and the normals there. The differences of neighbouring
// nodes are per node spacing; a stretched lattice turns them into slopes by its own. Aims at 30
// instructions a vertex.
[[gnu::always_inline]] inline void interpolateFour(const Halo& halo, const Vec3f& perSpacing,
                                                   float iso, std::size_t i, CrossedEdges& edges,
                                                   Vec3f* normals) {
  struct Ends {
    const float* node[4];
    explicit Ends(const Halo& halo, const std::int32_t* place)
        : node{&halo[std::size_t(place[0])], &halo[std::size_t(place[1])],
               &halo[std::size_t(place[2])], &halo[std::size_t(place[3])]} {}
    // The values a step on from them.
    Four operator[](int step) const {
      return Four{node[0][step], node[1][step], node[2][step], node[3][step]};
    }
  };
  const Ends low(halo, &edges.low[i]), high(halo, &edges.high[i]);
  const Four crossing = (iso - low[0]) / (high[0] - low[0]);
  const Four least = Four{} + kEndMargin, most = 1 - least;
  Four way = crossing > least ? crossing : least;
  way = way < most ? way : most;
  std::memcpy(&edges.way[i], &way, sizeof way);

  Four slope[3];
  for (int k = 0; k < 3; ++k) {
    const Four below = low[kStep[k]] - low[-kStep[k]], above = high[kStep[k]] - high[-kStep[k]];
    slope[k] = ((1 - way) * below + way * above) * perSpacing[k];
  }
  const Four square = slope[0] * slope[0] + (slope[1] * slope[1] + slope[2] * slope[2]);
  Four root;
  for (int lane = 0; lane < 4; ++lane) root[lane] = std::sqrt(square[lane]);
  // The root and the quotient do not wait for each other.
  const Four outwards = -root * (1 / square), none{};
  const Four x = square > none ? slope[0] * outwards : none,
             y = square > none ? slope[1] * outwards : none + 1,
             z = square > none ? slope[2] * outwards : none;
  const Four first = __builtin_shufflevector(x, y, 0, 4, 1, 5),
             second = __builtin_shufflevector(x, y, 2, 6, 3, 7);
  const Two xy[4] = {
      __builtin_shufflevector(first, first, 0, 1), __builtin_shufflevector(first, first, 2, 3),
      __builtin_shufflevector(second, second, 0, 1), __builtin_shufflevector(second, second, 2, 3)};
  for (int lane = 0; lane < 4; ++lane) {
    std::memcpy(normals[lane].data(), &xy[lane], sizeof xy[lane]);
    normals[lane].z() = z[lane];
  }
}

}  // namespace

RESECT_WIDEST
void brickVertices(const ColourField& field, const Vec3i& brick, const BrickSigns& signs, float iso,
                   Vec3f* points, Vec3f* normals, float* cut) {
  Halo halo;
  gatherHalo(field, brick, halo);
  CrossedEdges edges;
  edges.add<0>(signs.crossing[0]);
  edges.add<1>(signs.crossing[1]);
  edges.add<2>(signs.crossing[2]);
  edges.fillUp();
  const Vec3 step = field.lattice().spacing / field.refine();
  const Vec3f spacing = step.cast<float>(), perSpacing = spacing.cwiseInverse();
  for (std::size_t i = 0; i < std::size_t(edges.count); i += 4)
    interpolateFour(halo, perSpacing, iso, i, edges, normals + i);

  const Vec3i first = kBrickNodes * brick;
  const Vec3 origin = field.nodePosition(first.cast<double>());
  Vec3f nodes[kBrickNodes];  // where the nodes lie: x of those with that number along x, ...
  for (int n = 0; n < kBrickNodes; ++n) nodes[n] = Vec3(origin + n * step).cast<float>();
  const auto place = [&]<int kAxis>() {
    for (int i = signs.firstVertex[kAxis]; i < signs.firstVertex[kAxis + 1]; ++i) {
      const int node = edges.node[std::size_t(i)];
      Vec3f p(nodes[node & 3].x(), nodes[node >> 2 & 3].y(), nodes[node >> 4].z());
      p[kAxis] += edges.way[std::size_t(i)] * spacing[kAxis];
      points[i] = p;
    }
  };
  place.operator()<0>();
  place.operator()<1>();
  place.operator()<2>();
  std::fill_n(cut, edges.count, 0.f);
  if (!field.edited(field.brickIndex(brick))) return;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = signs.firstVertex[axis]; i < signs.firstVertex[axis + 1]; ++i) {
      const int node = edges.node[i];
      const Vec3i from = first + Vec3i(node & 3, node >> 2 & 3, node >> 4);
      const float t = edges.way[i];
      const float before =
          (1 - t) * field.originalNode(from) + t * field.originalNode(from + Vec3i::Unit(axis));
      cut[i] = std::clamp((before - iso) / kCutRange, 0.f, 1.f);
    }
}

}  // namespace resect
