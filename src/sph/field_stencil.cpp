#include "sph/field_stencil.h"

#include <cstring>

#include "base/error.h"
#include "base/instruction_set.h"
#include "sph/kernel.h"
#include "sph/mirrored_sums.h"

// All functions that return such vectors are inlined, so the calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {
namespace {

float weightAt(const Vec3& cells) { return float(kernel(cells.norm(), kSmoothingPerSpacing)); }

// ---- one or two nodes a cell: mirrored sums ----

template <int kRefine>
[[gnu::always_inline]] inline Mirrored<Row> mirroredAlongX(const float* cell) {
  const Row a = rowAt(cell), b = rowAt(cell + 1);
  if constexpr (kRefine == 1) return {b, a + rowAt(cell + 2)};
  const Row both = a + b;
  return {__builtin_shufflevector(a, both, 1, 5, 2, 6),
          __builtin_shufflevector(a, a, 0, 0, 1, 1) + __builtin_shufflevector(b, b, 1, 2, 2, 3)};
}

// The rows y and y + 1 of a plane of cells, arranged for two rows of nodes.
template <int kRefine, std::size_t kRows>
[[gnu::always_inline]] inline void pairRows(const float* plane, std::ptrdiff_t alongY,
                                            Mirrored<Half> (&rows)[kRows]) {
  Mirrored<Row> last = mirroredAlongX<kRefine>(plane);
#pragma GCC unroll 8
  for (std::size_t y = 0; y < kRows; ++y) {
    const auto next = mirroredAlongX<kRefine>(plane + std::ptrdiff_t(y + 1) * alongY);
    rows[y] = {join(last.near, next.near), join(last.far, next.far)};
    last = next;
  }
}

// One node a cell: each lies on its cell's centre and reaches the 26 neighbours; face, edge and
// corner neighbours have one weight each. Rows 0 and 1 of the nodes are processed together, then 2
// and 3. Aims at 19 additions and products a node, eight nodes at a time.
[[gnu::always_inline]] inline void sumOnCells(const FieldStencil& stencil, const float* low,
                                              std::ptrdiff_t alongY, std::ptrdiff_t alongZ,
                                              unsigned planes, float* out) {
  constexpr int kCells = 6;  // in reach of a brick along an axis
  // Sums of each plane of cells: the node's own column, its four face neighbours, its four diagonal
  // neighbours.
  Half own[2][kCells], beside[2][kCells], across[2][kCells];
#pragma GCC unroll 6
  for (int z = 0; z < kCells; ++z) {
    Mirrored<Half> rows[kCells - 1];
    pairRows<1>(low + z * alongZ, alongY, rows);
#pragma GCC unroll 2
    for (int pair = 0; pair < 2; ++pair) {
      const auto &below = rows[2 * pair], &level = rows[2 * pair + 1], &above = rows[2 * pair + 2];
      own[pair][z] = level.near;
      beside[pair][z] = level.far + (below.near + above.near);
      across[pair][z] = below.far + above.far;
    }
  }
  const auto& weight = stencil.mirrored[0][0];
  const Half ofOwn = half(weight[0]), ofFaces = half(weight[1]), ofEdges = half(weight[3]),
             ofCorners = half(weight[7]);
#pragma GCC unroll 2
  for (int pair = 0; pair < 2; ++pair)
#pragma GCC unroll 4
    for (int plane = 0; plane < kBrickNodes; ++plane) {
      if (!(planes >> plane & 1)) continue;
      const Half *o = own[pair] + plane, *b = beside[pair] + plane, *a = across[pair] + plane;
      const Half faces = b[1] + (o[0] + o[2]), edges = a[1] + (b[0] + b[2]), corners = a[0] + a[2];
      const Half sum = (o[1] * ofOwn + faces * ofFaces) + (edges * ofEdges + corners * ofCorners);
      std::memcpy(out + (plane * kBrickNodes + 2 * pair) * kBrickNodes, &sum, sizeof sum);
    }
}

// Two nodes a cell.
[[gnu::always_inline]] inline void sumBetweenCells(const FieldStencil& stencil, const float* low,
                                                   std::ptrdiff_t alongY, std::ptrdiff_t alongZ,
                                                   unsigned planes, float* out) {
  SumsBetween sums;
  for (int z = 0; z < kCellsBetween; ++z) {
    Mirrored<Half> rows[kCellsBetween - 1];
    pairRows<2>(low + z * alongZ, alongY, rows);
#pragma GCC unroll 2
    for (int row = 0; row < 2; ++row) {
      const auto near = mirrored(row, [&](int y) { return rows[y].near; });
      const auto far = mirrored(row, [&](int y) { return rows[y].far; });
      sums[row][z][0] = near.near, sums[row][z][1] = far.near;
      sums[row][z][2] = near.far, sums[row][z][3] = far.far;
    }
  }
  weighBetween(stencil, sums, planes, out);
}

void makeMirrored(FieldStencil& stencil) {
  for (int y = 0; y < stencil.refine; ++y)
    for (int z = 0; z < stencil.refine; ++z)
      for (int k = 0; k < 8; ++k)
        for (int lane = 0; lane < 8; ++lane) {
          const Vec3 place = Vec3(lane % stencil.refine, y, z) / 2;
          stencil.mirrored[y][z][k][lane] = weightAt(place + Vec3(k & 1, k >> 1 & 1, k >> 2 & 1));
        }
}

// ---- three or four nodes a cell: the plain sum ----

constexpr int kReach = 4;     // cells in reach of a node along an axis
constexpr int kMostRows = 5;  // in reach of a brick

// Cells round a brick, gathered for a pair of rows of its nodes: [z][y][dx] holds, for each node,
// the cell dx beyond its first cell in row y of plane z. The second row of nodes reads row y too,
// or the next.
using CellTable = Half[kMostRows][kMostRows][kReach];

// For a brick's nodes along each axis: their cell relative to the first node's.
using CellSteps = int[3][kBrickNodes];

// Fills the tables for the brick's pairs of rows: [0] for pairs in the same row of cells, [1] for
// pairs whose second row lies in the next.
[[gnu::always_inline]] inline void gatherCells(const float* low, std::ptrdiff_t alongY,
                                               std::ptrdiff_t alongZ, const CellSteps& place,
                                               CellTable* tables) {
  const int planes = place[2][kBrickNodes - 1] + kReach;
  const int rows = place[1][kBrickNodes - 1] + kReach;
  const bool unused[2] = {place[1][1] != place[1][0] && place[1][3] != place[1][2],
                          place[1][1] == place[1][0] && place[1][3] == place[1][2]};
  for (int z = 0; z < planes; ++z) {
    Row seen[kMostRows][kReach];
    for (int y = 0; y < rows; ++y)
      for (int dx = 0; dx < kReach; ++dx) {
        const float* cell = low + z * alongZ + y * alongY + dx;
        seen[y][dx] =
            Row{cell[place[0][0]], cell[place[0][1]], cell[place[0][2]], cell[place[0][3]]};
      }
    for (int step = 0; step < 2; ++step) {
      if (unused[step]) continue;
      for (int y = 0; y + step < rows; ++y)
        for (int dx = 0; dx < kReach; ++dx)
          tables[step][z][y][dx] = join(seen[y][dx], seen[y + step][dx]);
    }
  }
}

// Processes two planes of equal phase at a time, so that each weight is loaded once for both. Every
// node adds its cells in the same order in any plane or brick; a tap out of its reach adds an exact
// zero. Aims at one product and one addition per tap for eight nodes; the four independent sums of
// a pair of planes hide the latency.
[[gnu::always_inline]] inline void sumTaps(const FieldStencil& stencil, const Vec3i& phase,
                                           const float* low, std::ptrdiff_t alongY,
                                           std::ptrdiff_t alongZ, unsigned planes, float* out) {
  const int refine = stencil.refine;
  CellSteps place;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < kBrickNodes; ++i) place[a][i] = (phase[a] + i) / refine;
  CellTable tables[2];
  gatherCells(low, alongY, alongZ, place, tables);
  // The cells for the two halves of plane z.
  const auto seenBy = [&](int z, int half) {
    const int y = place[1][2 * half], step = place[1][2 * half + 1] - y;
    return &tables[step][place[2][z]][y][0];
  };
  for (int z = 0; z < kBrickNodes; ++z) {
    if (!(planes >> z & 1)) continue;
    // The next plane of the same phase; if there is none, the plane itself.
    const int other = z + refine < kBrickNodes && (planes >> (z + refine) & 1) ? z + refine : z;
    planes &= ~(1u << other);
    const Half *cells0 = seenBy(z, 0), *cells1 = seenBy(z, 1);
    const Half *cells2 = seenBy(other, 0), *cells3 = seenBy(other, 1);
    Half sum0 = {}, sum1 = {}, sum2 = {}, sum3 = {};
    const std::size_t kind = stencil.phaseIndex({phase.x(), phase.y(), (phase.z() + z) % refine});
    for (const FieldStencil::Tap& tap : stencil.taps[kind]) {
      const Half weight0 = half(tap.weight[0]), weight1 = half(tap.weight[1]);
      sum0 += cells0[tap.offset] * weight0;
      sum1 += cells1[tap.offset] * weight1;
      sum2 += cells2[tap.offset] * weight0;
      sum3 += cells3[tap.offset] * weight1;
    }
    const auto store = [&](const Half& sum, int row) {
      std::memcpy(out + row * kBrickNodes, &sum, sizeof sum);
    };
    store(sum0, z * kBrickNodes);
    store(sum1, z * kBrickNodes + 2);
    store(sum2, other * kBrickNodes);
    store(sum3, other * kBrickNodes + 2);
  }
}

// In reach of a node are the cells nearer than the kernel's radius of two cells.
void makeTaps(FieldStencil& stencil) {
  const int refine = stencil.refine;
  for (int z = 0; z < refine; ++z)
    for (int phaseY = 0; phaseY < stencil.phases; ++phaseY)
      for (int phaseX = 0; phaseX < stencil.phases; ++phaseX) {
        std::vector<FieldStencil::Tap>& taps = stencil.taps.emplace_back();
        for (int dz = 0; dz < kReach; ++dz)
          for (int dy = 0; dy < kReach; ++dy)
            for (int dx = 0; dx < kReach; ++dx) {
              FieldStencil::Tap tap{{}, (dz * kMostRows + dy) * kReach + dx};
              bool reached = false;
              for (int y = 0; y < kBrickNodes; ++y)
                for (int x = 0; x < kBrickNodes; ++x) {
                  const Vec3 place((phaseX + x) % refine, (phaseY + y) % refine, z);
                  const float weight = weightAt(Vec3(dx - 1, dy - 1, dz - 1) - place / refine);
                  tap.weight[y / 2][y % 2 * kBrickNodes + x] = weight;
                  reached = reached || weight > 0;
                }
              if (reached) taps.push_back(tap);
            }
      }
}

FieldStencil makeStencil(int refine) {
  FieldStencil stencil{refine, refine == 3 ? 3 : 1, {}, {}, {}};
  if (refine <= 2)
    makeMirrored(stencil);
  else
    makeTaps(stencil);
  constexpr int kSide = 8;  // cells round any brick
  const std::vector<float> solid(kSide * kSide * kSide, 100.f);
  stencil.full.assign(std::size_t(stencil.phases * stencil.phases * stencil.phases) * kBrickSize,
                      0.f);
  for (int z = 0; z < stencil.phases; ++z)
    for (int y = 0; y < stencil.phases; ++y)
      for (int x = 0; x < stencil.phases; ++x)
        sumBrick(stencil, {x, y, z}, solid.data(), kSide, kSide * kSide, 0xf,
                 stencil.full.data() + stencil.phaseIndex({x, y, z}) * kBrickSize);
  return stencil;
}

}  // namespace

const FieldStencil& fieldStencil(int refine) {
  require(refine >= 1 && refine <= 4, "refine is {}; give 1, 2, 3 or 4 surface nodes per cell",
          refine);
  static const std::array<FieldStencil, 4> stencils = {makeStencil(1), makeStencil(2),
                                                       makeStencil(3), makeStencil(4)};
  return stencils[std::size_t(refine - 1)];
}

RESECT_WIDEST
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const float* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out) {
  switch (stencil.refine) {
    case 1:
      return sumOnCells(stencil, low, alongY, alongZ, planes, out);
    case 2:
      return sumBetweenCells(stencil, low, alongY, alongZ, planes, out);
    default:
      return sumTaps(stencil, phase, low, alongY, alongZ, planes, out);
  }
}

}  // namespace resect
