#include "surface/brick_mesher.h"

#include <algorithm>

#include "base/instruction_set.h"

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
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const Vec3i b = brick + Vec3i(x - 1, y - 1, z - 1);
        const bool exists = (b.array() >= 0).all() && (b.array() < field.brickDims().array()).all();
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

Vec3f gradient(const Halo& halo, int node) {
  return {halo[node + kStep[0]] - halo[node - kStep[0]],
          halo[node + kStep[1]] - halo[node - kStep[1]],
          halo[node + kStep[2]] - halo[node - kStep[2]]};
}

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
  int count = 0;
  visitCells(corners, except, [&](int, const CellTriangles& drawn) { count += drawn.count; });
  return count;
}

RESECT_WIDEST
void brickVertices(const ColourField& field, const Vec3i& brick, const BrickSigns& signs, float iso,
                   SurfaceVertex* out) {
  Halo halo;
  gatherHalo(field, brick, halo);
  const Vec3i first = kBrickNodes * brick;
  const bool edited = field.edited(field.brickIndex(brick));
  for (int axis = 0; axis < 3; ++axis)
    for (std::uint64_t rest = signs.crossing[axis]; rest != 0; rest &= rest - 1) {
      const int node = std::countr_zero(rest);
      const Vec3i local(node & 3, node >> 2 & 3, node >> 4);
      const int a = at(local.x(), local.y(), local.z()), b = a + kStep[axis];
      const float t = std::clamp((iso - halo[a]) / (halo[b] - halo[a]), kEndMargin, 1 - kEndMargin);
      Vec3 where = (first + local).cast<double>();
      where[axis] += t;
      out->position = field.nodePosition(where).cast<float>();
      // Node differences are per node spacing; a stretched lattice turns them into slopes by its
      // own spacing.
      const Vec3f slope = ((1 - t) * gradient(halo, a) + t * gradient(halo, b))
                              .cwiseQuotient(field.lattice().spacing.cast<float>());
      const float length = slope.norm();
      out->normal = length > 0 ? Vec3f(slope / -length) : Vec3f(0, 1, 0);
      out->cut = 0;
      if (edited) {
        const Vec3i from = first + local;
        const float before =
            (1 - t) * field.originalNode(from) + t * field.originalNode(from + Vec3i::Unit(axis));
        out->cut = std::clamp((before - iso) / kCutRange, 0.f, 1.f);
      }
      ++out;
    }
}

}  // namespace resect
