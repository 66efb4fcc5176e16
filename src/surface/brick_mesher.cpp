#include "surface/brick_mesher.h"

#include <algorithm>
#include <cmath>

#include "base/instruction_set.h"
#include "surface/marching_cubes_table.h"

namespace resect {
namespace {

// Nodes -1 to 5 of a brick along each axis, x fastest: all that its vertices and their normals
// depend on.
constexpr int kHalo = 7;
using Halo = std::array<float, kHalo * kHalo * kHalo>;
constexpr int kStep[3] = {1, kHalo, kHalo* kHalo};

// Place in the halo of the brick's node (x, y, z), each -1 to 5.
constexpr int at(int x, int y, int z) { return ((z + 1) * kHalo + y + 1) * kHalo + x + 1; }

// The values of all nodes of the halo; 0 outside the grid.
void gatherHalo(const ColourField& field, const Vec3i& brick, Halo& halo) {
  static constexpr float kOutside[kBrickSize] = {};
  const float* around[3][3][3];  // the nodes of the brick and of its 26 neighbours
  const Vec3i last = field.brickDims() - Vec3i::Ones();
  const bool within = (brick.array() > 0).all() && (brick.array() < last.array()).all();
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const Vec3i b = brick + Vec3i(x - 1, y - 1, z - 1);
        const bool exists = within || ((b.array() >= 0).all() && (b.array() <= last.array()).all());
        around[z][y][x] = exists ? field.nodes(b) : kOutside;
      }
  for (int z = -1; z <= 5; ++z)
    for (int y = -1; y <= 5; ++y) {
      // Row (y, z) of the halo: the last node of the brick to the left, all four of the middle, the
      // first two of the brick to the right.
      const auto& bricks = around[(z >> 2) + 1][(y >> 2) + 1];
      const int row = ((z & 3) * 4 + (y & 3)) * 4;
      float* out = &halo[at(-1, y, z)];
      out[0] = bricks[0][row + 3];
      std::copy_n(bricks[1] + row, 4, out + 1);
      std::copy_n(bricks[2] + row, 2, out + 5);
    }
}

// Vertices keep this share of an edge away from its ends, so that no two of them fall together.
constexpr float kEndMargin = 1e-3f;
// Colour values below the iso level of the original field over which skin turns into cut
// parenchyma.
constexpr float kCutRange = 15;

// The crossed edges of a brick, number by number: values and differences of values at both ends,
// and what comes of them.
struct CrossedEdges {
  template <typename T>
  using List = std::array<T, 3 * kBrickSize>;
  int count = 0;
  List<std::uint8_t> axes, nodes;                            // nodes: the lower ends, 0 to 63
  List<float> low, high;                                     // values at the ends
  std::array<List<float>, 3> lowDifference, highDifference;  // per axis, of the nodes on both sides
  List<float> way;                                           // of the vertex along the edge, 0 to 1
  List<float> length;                                        // of the slope
  std::array<List<float>, 3> normal;

  void add(const Halo& halo, int axis, int node) {
    const int a = at(node & 3, node >> 2 & 3, node >> 4), b = a + kStep[axis];
    axes[count] = std::uint8_t(axis);
    nodes[count] = std::uint8_t(node);
    low[count] = halo[a];
    high[count] = halo[b];
    for (int k = 0; k < 3; ++k) {
      lowDifference[k][count] = halo[a + kStep[k]] - halo[a - kStep[k]];
      highDifference[k][count] = halo[b + kStep[k]] - halo[b - kStep[k]];
    }
    ++count;
  }

  // Fills `way` and `normal`: plain loops over arrays, which the compiler turns into vectors.
  [[gnu::always_inline]] void interpolate(float iso, const Vec3f& spacing) {
    const float sx = spacing.x(), sy = spacing.y(), sz = spacing.z();
    for (int i = 0; i < count; ++i) {
      const float t = (iso - low[i]) / (high[i] - low[i]);
      way[i] = t < kEndMargin ? kEndMargin : t > 1 - kEndMargin ? 1 - kEndMargin : t;
    }
    for (int i = 0; i < count; ++i) {
      const float t = way[i], rest = 1 - t;
      // Node differences are per node spacing; a stretched lattice turns them into slopes by its
      // own spacing.
      const float x = (rest * lowDifference[0][i] + t * highDifference[0][i]) / sx;
      const float y = (rest * lowDifference[1][i] + t * highDifference[1][i]) / sy;
      const float z = (rest * lowDifference[2][i] + t * highDifference[2][i]) / sz;
      length[i] = std::sqrt(x * x + (y * y + z * z));
      normal[0][i] = x / -length[i];
      normal[1][i] = y / -length[i];
      normal[2][i] = z / -length[i];
    }
    for (int i = 0; i < count; ++i)
      if (!(length[i] > 0)) normal[0][i] = 0, normal[1][i] = 1, normal[2][i] = 0;
  }
};

}  // namespace

RESECT_WIDEST
std::uint64_t insideMask(std::span<const float, kBrickSize> nodes, float iso) {
  std::uint64_t mask = 0;
  for (int node = 0; node < kBrickSize; ++node) mask |= std::uint64_t(nodes[node] >= iso) << node;
  return mask;
}

std::array<std::uint64_t, 8> cornerMasks(const std::array<std::uint64_t, 8>& inside) {
  // The masks one node further along an axis: bits move down, those of the neighbour come in.
  const auto alongX = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 1 & 0x7777777777777777) | (next & 0x1111111111111111) << 3;
  };
  const auto alongY = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 4 & 0x0fff0fff0fff0fff) | (next & 0x000f000f000f000f) << 12;
  };
  const auto alongZ = [](std::uint64_t own, std::uint64_t next) { return own >> 16 | next << 48; };
  std::array<std::uint64_t, 8> mask = inside;
  for (const int d : {0, 2, 4, 6}) mask[d + 1] = alongX(inside[d], inside[d + 1]);
  for (const int d : {0, 1, 4, 5}) mask[d + 2] = alongY(mask[d], mask[d + 2]);
  for (const int d : {0, 1, 2, 3}) mask[d + 4] = alongZ(mask[d], mask[d + 4]);
  return mask;
}

RESECT_WIDEST
int countTriangles(const std::array<std::uint64_t, 8>& corners, std::uint64_t except) {
  const auto& table = marchingCubesTable();
  int count = 0;
  visitCells(corners, except, [&](int, int kind) { count += table[std::size_t(kind)].count; });
  return count;
}

RESECT_WIDEST
void brickVertices(const ColourField& field, const Vec3i& brick, const BrickSigns& signs, float iso,
                   SurfaceVertex* out) {
  Halo halo;
  gatherHalo(field, brick, halo);
  CrossedEdges edges;
  for (int axis = 0; axis < 3; ++axis)
    for (std::uint64_t rest = signs.crossing[axis]; rest != 0; rest &= rest - 1)
      edges.add(halo, axis, std::countr_zero(rest));
  edges.interpolate(iso, field.lattice().spacing.cast<float>());

  const Vec3i first = kBrickNodes * brick;
  const bool edited = field.edited(field.brickIndex(brick));
  Vec3f nodes[kBrickNodes];  // where the nodes lie: x of those with that number along x, ...
  for (int n = 0; n < kBrickNodes; ++n)
    nodes[n] = field.nodePosition((first + Vec3i::Constant(n)).cast<double>()).cast<float>();
  for (int i = 0; i < edges.count; ++i, ++out) {
    const int axis = edges.axes[i], node = edges.nodes[i];
    const Vec3i local(node & 3, node >> 2 & 3, node >> 4);
    out->position = {nodes[local.x()].x(), nodes[local.y()].y(), nodes[local.z()].z()};
    out->position[axis] =
        float(field.nodePlace(axis, first[axis] + local[axis] + double(edges.way[i])));
    out->normal = {edges.normal[0][i], edges.normal[1][i], edges.normal[2][i]};
    out->cut = 0;
    if (edited) {
      const Vec3i from = first + local;
      const float t = edges.way[i];
      const float before =
          (1 - t) * field.originalNode(from) + t * field.originalNode(from + Vec3i::Unit(axis));
      out->cut = std::clamp((before - iso) / kCutRange, 0.f, 1.f);
    }
  }
}

}  // namespace resect
