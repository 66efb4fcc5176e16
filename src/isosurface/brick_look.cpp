#include "isosurface/brick_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/instruction_set.h"
#include "isosurface/vertex_fours.h"

// All functions that return rows of eight are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {
namespace {

// Nodes -1 to 5 of a brick along each axis, x fastest. A row has eight elements; the last is
// unused.
constexpr int kHalo = 7, kRow = 8;
typedef float Row __attribute__((vector_size(kRow * sizeof(float))));
using Halo = std::array<std::array<Row, kHalo>, kHalo>;  // [z + 1][y + 1]

// Nodes of three consecutive bricks along x.
struct BrickRow {
  const float *left, *middle, *right;
};

[[gnu::always_inline]] inline BrickRow rowOf(const ColourField& field, const Vec3i& middle) {
  static constexpr float kOutside[kBrickSize] = {};
  const Vec3i& dims = field.brickDims();
  if (middle.y() < 0 || middle.z() < 0 || middle.y() >= dims.y() || middle.z() >= dims.z())
    return {kOutside, kOutside, kOutside};
  const std::int64_t index = field.brickIndex(middle);
  return {middle.x() > 0 ? field.nodes(index - 1) : kOutside, field.nodes(index),
          middle.x() + 1 < dims.x() ? field.nodes(index + 1) : kOutside};
}

// 0 outside the grid.
[[gnu::always_inline]] inline void gatherHalo(const ColourField& field, const Vec3i& brick,
                                              Halo& halo) {
  // Along an axis: the last node of the brick below, the first two of the brick above.
  constexpr int kFirst[3] = {kBrickNodes - 1, 0, 0}, kEnd[3] = {kBrickNodes, kBrickNodes, 2};
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy) {
      const BrickRow bricks = rowOf(field, brick + Vec3i(0, dy, dz));
      for (int z = kFirst[dz + 1]; z < kEnd[dz + 1]; ++z)
        for (int y = kFirst[dy + 1]; y < kEnd[dy + 1]; ++y) {
          const int first = (z * kBrickNodes + y) * kBrickNodes;
          FourFloats left, right, middle;
          std::memcpy(&left, bricks.left + first, sizeof left);
          std::memcpy(&middle, bricks.middle + first, sizeof middle);
          std::memcpy(&right, bricks.right + first, sizeof right);
          const FourFloats low = __builtin_shufflevector(left, middle, 3, 4, 5, 6),
                           high = __builtin_shufflevector(middle, right, 3, 4, 5, 5);
          Row& row =
              halo[std::size_t(kBrickNodes * dz + z + 1)][std::size_t(kBrickNodes * dy + y + 1)];
          row = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
        }
    }
}

// Nodes 0 to 4 of a brick: their values, and per axis 32 times the field's difference per node.
constexpr int kNodes = kBrickNodes + 1;
constexpr int placeOf(int x, int y, int z) { return (z * kNodes + y) * kRow + x; }
using NodeNumbers = std::array<float, kNodes * kNodes * kRow>;  // by placeOf()
struct Slopes {
  NodeNumbers value, along[3];
};

// The row shifted by one, by two nodes along x; the last elements are unused.
[[gnu::always_inline]] inline Row next(const Row& r) {
  return __builtin_shufflevector(r, r, 1, 2, 3, 4, 5, 6, 7, 7);
}
[[gnu::always_inline]] inline Row afterNext(const Row& r) {
  return __builtin_shufflevector(r, r, 2, 3, 4, 5, 6, 7, 7, 7);
}
[[gnu::always_inline]] inline Row smoothed(const Row& before, const Row& here, const Row& behind) {
  return (before + behind) + (here + here);
}

[[gnu::always_inline]] inline void findSlopes(const Halo& halo, Slopes& slopes) {
  for (int z = 0; z < kNodes; ++z) {
    // Averages and differences along z of the planes before, at and after the nodes.
    std::array<Row, kHalo> mean, growth;
    for (int y = 0; y < kHalo; ++y) {
      const Row &before = halo[z][y], &here = halo[z + 1][y], &behind = halo[z + 2][y];
      mean[y] = smoothed(before, here, behind);
      growth[y] = behind - before;
    }
    for (int y = 0; y < kNodes; ++y) {
      const Row flat = smoothed(mean[y], mean[y + 1], mean[y + 2]), alongY = mean[y + 2] - mean[y],
                alongZ = smoothed(growth[y], growth[y + 1], growth[y + 2]);
      const auto put = [&](const Row& row, NodeNumbers& to) __attribute__((always_inline)) {
        std::memcpy(&to[std::size_t(placeOf(0, y, z))], &row, sizeof row);
      };
      put(next(halo[z + 1][y + 1]), slopes.value);
      put(afterNext(flat) - flat, slopes.along[0]);
      put(smoothed(alongY, next(alongY), afterNext(alongY)), slopes.along[1]);
      put(smoothed(alongZ, next(alongZ), afterNext(alongZ)), slopes.along[2]);
    }
  }
}

// For each edge of a brick, by number: the indices of its nodes in Slopes.
struct EdgeEnds {
  std::array<std::uint8_t, kBrickEdges + 1> low{}, high{};
};
constexpr EdgeEnds kEnds = [] {
  EdgeEnds ends;
  constexpr int kStep[3] = {placeOf(1, 0, 0), placeOf(0, 1, 0), placeOf(0, 0, 1)};
  for (std::size_t edge = 0; edge < kBrickEdges; ++edge) {
    const int node = edge % kBrickSize, low = placeOf(node & 3, node >> 2 & 3, node >> 4);
    ends.low[edge] = std::uint8_t(low);
    ends.high[edge] = std::uint8_t(low + kStep[edge / kBrickSize]);
  }
  return ends;
}();

// Range of the original field's value above the iso level over which the cut share goes from 0 to
// 1.
constexpr float kCutRange = 15;

}  // namespace

float cutShare(float before, float iso) { return std::clamp((before - iso) / kCutRange, 0.f, 1.f); }

RESECT_WIDEST
void brickLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
               std::span<const std::uint8_t> edges, Vec3f* normals, float* cut) {
  const Vec3i place = field.brick(brick);
  Halo halo;
  gatherHalo(field, place, halo);
  Slopes slopes;
  findSlopes(halo, slopes);
  const bool edited = field.cellsEdited(brick);
  for (std::size_t i = 0; i < edges.size(); i += 4) {
    // Beyond the last vertex the last one's edge is used.
    std::size_t low[4], high[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint8_t edge = edges[std::min(i + k, edges.size() - 1)];
      low[k] = kEnds.low[edge], high[k] = kEnds.high[edge];
    }
    const auto four =
        [](const NodeNumbers& numbers, const std::size_t(&at)[4]) __attribute__((always_inline)) {
      return FourFloats{numbers[at[0]], numbers[at[1]], numbers[at[2]], numbers[at[3]]};
    };
    const FourFloats way =
        wayAlong(four(slopes.value, low), four(slopes.value, high), grid.iso, kEndMargin);
    FourFloats along[3], square{};
    for (int k = 0; k < 3; ++k) {
      // Differences per node become slopes by the spacing of each axis.
      along[k] = ((1 - way) * four(slopes.along[k], low) + way * four(slopes.along[k], high)) *
                 grid.perSpacing[k];
      square += along[k] * along[k];
    }
    FourFloats root;
    for (int lane = 0; lane < 4; ++lane) root[lane] = std::sqrt(square[lane]);
    const FourFloats none{}, outwards = -1 / root;
    storePoints(square > none ? along[0] * outwards : none,
                square > none ? along[1] * outwards : none + 1,
                square > none ? along[2] * outwards : none, normals + i);
    for (std::size_t k = 0; k < 4; ++k) cut[i + k] = 0;
    if (!edited) continue;
    for (std::size_t k = i; k < std::min(i + 4, edges.size()); ++k) {
      const int node = edges[k] % kBrickSize;
      const Vec3i from = kBrickNodes * place + Vec3i(node & 3, node >> 2 & 3, node >> 4);
      const float t = way[k - i], below = field.originalNode(from),
                  above = field.originalNode(from + Vec3i::Unit(edges[k] / kBrickSize));
      // Where nothing changed, the share is 0, even of a vertex that was kept off its edge's end.
      if (below != slopes.value[low[k - i]] || above != slopes.value[high[k - i]])
        cut[k] = cutShare((1 - t) * below + t * above, grid.iso);
    }
  }
}

}  // namespace resect
