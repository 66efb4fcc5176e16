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

// For each edge of a brick, by number: the places of its ends.
struct EdgeEnds {
  std::array<std::uint16_t, kBrickEdges + 1> low{}, high{};
};
constexpr EdgeEnds kEnds = [] {
  EdgeEnds ends;
  for (std::size_t edge = 0; edge < kBrickEdges; ++edge) {
    const int node = int(edge % kBrickSize), low = at(node & 3, node >> 2 & 3, node >> 4);
    ends.low[edge] = std::uint16_t(low);
    ends.high[edge] = std::uint16_t(low + kStep[edge / kBrickSize]);
  }
  ends.low[kNoEdge] = ends.high[kNoEdge] = std::uint16_t(at(0, 0, 0));
  return ends;
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
#pragma GCC unroll 3
  for (int z = -1; z <= 1; ++z)
#pragma GCC unroll 3
    for (int y = -1; y <= 1; ++y) {
      BrickRow& row = rows[z + 1][y + 1];
      row.middle = nodesOf(0, y, z);
      if (y != 0 && z != 0) continue;
      row.left = nodesOf(-1, y, z);
      row.right = nodesOf(1, y, z);
    }
}

// The values of the nodes of the halo; 0 outside the grid. Nodes that differ from the brick along
// all three axes are left out. The brick's place comes as numbers, for a vector would be written to
// memory and read back in other pieces.
void gatherHalo(const ColourField& field, std::int64_t index, int x, int y, int z, Halo& halo) {
  static constexpr float kOutside[kBrickSize] = {};
  const int dimX = field.brickDims().x(), dimY = field.brickDims().y(),
            dimZ = field.brickDims().z();
  const std::int64_t alongY = dimX, alongZ = alongY * dimY;
  const auto nodesAt = [&](int dx, int dy, int dz) {
    return field.nodes(index + dx + dy * alongY + dz * alongZ);
  };
  BrickRow around[3][3];
  if (x > 0 && y > 0 && z > 0 && x + 1 < dimX && y + 1 < dimY && z + 1 < dimZ)
    findRows(around, nodesAt);
  else
    findRows(around, [&](int dx, int dy, int dz) {
      const bool exists = x + dx >= 0 && y + dy >= 0 && z + dz >= 0 && x + dx < dimX &&
                          y + dy < dimY && z + dz < dimZ;
      return exists ? nodesAt(dx, dy, dz) : kOutside;
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
typedef std::int32_t FourInts __attribute__((vector_size(16)));
typedef double FourDoubles __attribute__((vector_size(32)));

// Of four numbers those that the last two bits of `which` name.
[[gnu::always_inline]] inline Four chosen(const Four& numbers, const FourInts& which) {
#ifdef __clang__
  return Four{numbers[which[0] & 3], numbers[which[1] & 3], numbers[which[2] & 3],
              numbers[which[3] & 3]};
#else
  return __builtin_shuffle(numbers, which);
#endif
}

// Writes four points from their coordinates.
[[gnu::always_inline]] inline void store(const Four& x, const Four& y, const Four& z, Vec3f* out) {
  const Four zx = __builtin_shufflevector(z, x, 0, 0, 5, 5),
             yz = __builtin_shufflevector(y, z, 1, 1, 5, 5),
             zx3 = __builtin_shufflevector(z, x, 2, 2, 7, 7),
             yz3 = __builtin_shufflevector(y, z, 3, 3, 7, 7),
             low = __builtin_shufflevector(x, y, 0, 4, 1, 5),
             high = __builtin_shufflevector(x, y, 2, 6, 3, 7);
  const Four first = __builtin_shufflevector(low, zx, 0, 1, 4, 6),
             second = __builtin_shufflevector(yz, high, 0, 2, 4, 5),
             third = __builtin_shufflevector(zx3, yz3, 0, 2, 4, 6);
  float* to = out->data();
  std::memcpy(to, &first, sizeof first);
  std::memcpy(to + 4, &second, sizeof second);
  std::memcpy(to + 8, &third, sizeof third);
}

// The lower (or upper) ends of four edges.
struct Ends {
  const float* node[4];

  Ends(const Halo& halo, const decltype(kEnds.low)& place, const std::uint8_t* edge)
      : node{&halo[place[edge[0]]], &halo[place[edge[1]]], &halo[place[edge[2]]],
             &halo[place[edge[3]]]} {}
  // The values a step on from them.
  Four operator[](int step) const {
    return Four{node[0][step], node[1][step], node[2][step], node[3][step]};
  }
};

// What lies round four nodes along x: the values before them, at them and behind them.
struct AlongX {
  Four before, here, behind;

  // Four rows are read, not twelve numbers, and turned. Their last numbers are not used: they may
  // lie in a place of the halo that is not written.
  explicit AlongX(const Ends& ends) {
    Four row[4];
    for (int i = 0; i < 4; ++i) std::memcpy(&row[i], ends.node[i] - kStep[0], sizeof row[i]);
    const Four low01 = __builtin_shufflevector(row[0], row[1], 0, 4, 1, 5),
               low23 = __builtin_shufflevector(row[2], row[3], 0, 4, 1, 5),
               high01 = __builtin_shufflevector(row[0], row[1], 2, 6, 3, 7),
               high23 = __builtin_shufflevector(row[2], row[3], 2, 6, 3, 7);
    before = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
    here = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    behind = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  }
};

// What the field grows by along each axis round four nodes, from the nodes before to those behind.
struct Differences {
  Four along[3];
};
[[gnu::always_inline]] inline Differences differencesAt(const Ends& ends, const AlongX& x) {
  return {
      {x.behind - x.before, ends[kStep[1]] - ends[-kStep[1]], ends[kStep[2]] - ends[-kStep[2]]}};
}

// Where four edges cross the iso level, and what is round their lower and upper ends there.
struct Crossings {
  Four way;  // how far along, 0 to 1
  Differences below, above;
};

[[gnu::always_inline]] inline Crossings crossingsOf(const Halo& halo, float iso,
                                                    const std::uint8_t* edge) {
  const Ends lower(halo, kEnds.low, edge), upper(halo, kEnds.high, edge);
  const AlongX low(lower), high(upper);
  const Four crossing = (iso - low.here) / (high.here - low.here);
  const Four least = Four{} + kEndMargin, most = 1 - least;
  const Four way = crossing > least ? crossing : least;
  return {way < most ? way : most, differencesAt(lower, low), differencesAt(upper, high)};
}

struct Slopes {
  Four along[3];
};

// The field's slopes there. The differences of neighbouring nodes are per node spacing; a stretched
// lattice turns them into slopes by its own.
[[gnu::always_inline]] inline Slopes slopesAt(const Crossings& at, const Vec3f& perSpacing) {
  Slopes slopes;
  for (int k = 0; k < 3; ++k)
    slopes.along[k] =
        ((1 - at.way) * at.below.along[k] + at.way * at.above.along[k]) * perSpacing[k];
  return slopes;
}

[[gnu::always_inline]] inline void storeNormals(const Slopes& slopes, Vec3f* normals) {
  const Four *along = slopes.along, none{};
  const Four square = along[0] * along[0] + (along[1] * along[1] + along[2] * along[2]);
  Four root;
  for (int lane = 0; lane < 4; ++lane) root[lane] = std::sqrt(square[lane]);
  // The root and the quotient do not wait for each other.
  const Four outwards = -root * (1 / square);
  store(square > none ? along[0] * outwards : none, square > none ? along[1] * outwards : none + 1,
        square > none ? along[2] * outwards : none, normals);
}

// The places of a brick's four nodes along each axis, m.
using NodePlaces = std::array<Four, 3>;

[[gnu::always_inline]] inline NodePlaces nodePlaces(const ColourField& field, const NodeGrid& grid,
                                                    const Vec3i& brick) {
  NodePlaces places;
  for (int k = 0; k < 3; ++k) {
    const FourDoubles node{0, 1, 2, 3};
    places[std::size_t(k)] = __builtin_convertvector(
        field.nodePlace(k, kBrickNodes * brick[k]) + node * grid.step[k], Four);
  }
  return places;
}

[[gnu::always_inline]] inline void storePoints(const NodeGrid& grid, const NodePlaces& places,
                                               const std::uint8_t* edge, const Four& way,
                                               Vec3f* points) {
  typedef std::uint8_t FourBytes __attribute__((vector_size(4)));
  FourBytes bytes;
  std::memcpy(&bytes, edge, sizeof bytes);
  const FourInts number = __builtin_convertvector(bytes, FourInts), axis = number >> 6;
  Four at[3];
  for (int k = 0; k < 3; ++k) {
    const Four along = way * grid.spacing[k];
    at[k] = chosen(places[std::size_t(k)], number >> 2 * k) + (axis == k ? along : Four{});
  }
  store(at[0], at[1], at[2], points);
}

}  // namespace

// Step by step for all vertices, not vertex by vertex: so the divisions and roots of many are under
// way at once. Aims at 40 instructions a vertex.
RESECT_WIDEST
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, Vec3f* normals, float* cut,
                   std::uint8_t* edges) {
  const Vec3i place = field.brick(brick);
  Halo halo;
  gatherHalo(field, brick, place.x(), place.y(), place.z(), halo);
  const CrossedEdges crossed(signs);
  const std::uint8_t* edge = crossed.number.data();
  const NodePlaces places = nodePlaces(field, grid, place);
  constexpr std::size_t kMost = CrossedEdges::kMost / 4;
  std::array<Crossings, kMost> crossings;
  const std::size_t fours = std::size_t(signs.vertexCount() + 3) / 4;
  for (std::size_t i = 0; i < fours; ++i) crossings[i] = crossingsOf(halo, grid.iso, edge + 4 * i);
  for (std::size_t i = 0; i < fours; ++i)
    storeNormals(slopesAt(crossings[i], grid.perSpacing), normals + 4 * i);
  for (std::size_t i = 0; i < fours; ++i)
    storePoints(grid, places, edge + 4 * i, crossings[i].way, points + 4 * i);
  for (int i = 0; i < signs.vertexCount(); i += CrossedEdges::kStep) {
    std::memset(cut + i, 0, CrossedEdges::kStep * sizeof(float));
    std::memcpy(edges + i, edge + i, CrossedEdges::kStep);
  }
  if (!field.edited(brick)) return;
  const Vec3i first = kBrickNodes * place;
  for (int i = 0; i < signs.vertexCount(); ++i) {
    const Vec3i from = first + Vec3i(edge[i] & 3, edge[i] >> 2 & 3, edge[i] >> 4 & 3);
    const float t = crossings[std::size_t(i / 4)].way[i % 4];
    const float before = (1 - t) * field.originalNode(from) +
                         t * field.originalNode(from + Vec3i::Unit(edge[i] / kBrickSize));
    cut[i] = std::clamp((before - grid.iso) / kCutRange, 0.f, 1.f);
  }
}

}  // namespace resect
