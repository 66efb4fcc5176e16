// How is the stencil made, and how are the nodes of a brick summed over their cells?
#include <cstring>

#include "base/instruction_set.h"
#include "sph/colour_field.h"
#include "sph/kernel.h"

namespace resect {
namespace {

// The four nodes of a row of a brick, and two rows, half a plane, which machines with eight lanes
// add at once.
typedef float Row __attribute__((vector_size(16), may_alias));
typedef float Half __attribute__((vector_size(32), may_alias));

template <typename Plane>
[[gnu::always_inline]] inline const Half* halves(const Plane& plane) {
  return reinterpret_cast<const Half*>(plane.data());
}

// Cells round a brick as two rows of its nodes see them: at [z][y][dx] the cells dx on from where
// the nodes of the first row begin in row y of plane z. The second row of nodes sees row y as well,
// or the next.
constexpr int kAcross = 4, kMostRows = 7;
using CellTable = Half[kMostRows][kMostRows][kAcross];

// Places of a brick's nodes along the axes: cells on from the first node's.
using NodePlaces = int[3][kBrickNodes];

// Fills the tables that the brick's pairs of rows use: [0] where both rows of nodes see the same
// row of cells, [1] where the second one sees the next. kRefine: 1, 2, 4, or 0 for any.
template <int kRefine>
[[gnu::always_inline]] inline void gatherCells(const float* low, std::ptrdiff_t alongY,
                                               std::ptrdiff_t alongZ, const NodePlaces& place,
                                               CellTable* tables) {
  // A node on its cell's centre reaches one cell on, others two.
  constexpr int kCells = kRefine == 1 ? 3 : kAcross;
  const int planes = place[2][kBrickNodes - 1] + kCells;
  const int rows = place[1][kBrickNodes - 1] + kCells;
  const bool unused[2] = {place[1][1] != place[1][0] && place[1][3] != place[1][2],
                          place[1][1] == place[1][0] && place[1][3] == place[1][2]};
  for (int z = 0; z < planes; ++z) {
    Row seen[kMostRows + 1][kAcross];
    for (int y = 0; y < rows; ++y)
      for (int dx = 0; dx < kCells; ++dx) {
        const float* cell = low + z * alongZ + y * alongY + dx;
        Row& row = seen[y][dx];
        if constexpr (kRefine == 1)
          std::memcpy(&row, cell, sizeof row);
        else if constexpr (kRefine == 2)
          row = Row{cell[0], cell[0], cell[1], cell[1]};
        else if constexpr (kRefine == 4)
          row = Row{cell[0], cell[0], cell[0], cell[0]};
        else
          row = Row{cell[place[0][0]], cell[place[0][1]], cell[place[0][2]], cell[place[0][3]]};
      }
    for (int step = 0; step < 2; ++step) {
      if (unused[step]) continue;
      for (int y = 0; y + step < rows; ++y)
        for (int dx = 0; dx < kCells; ++dx)
          tables[step][z][y][dx] =
              __builtin_shufflevector(seen[y][dx], seen[y + step][dx], 0, 1, 2, 3, 4, 5, 6, 7);
    }
  }
}

}  // namespace

// A node reaches the cells nearer than the kernel's support of two cells.
void ColourField::makeTaps() {
  empty_.assign(kBrickSize, 0.f);
  full_.assign(std::size_t(phases_ * phases_ * phases_) * kBrickSize, 0.f);
  for (int z = 0; z < refine_; ++z)
    for (int phaseY = 0; phaseY < phases_; ++phaseY)
      for (int phaseX = 0; phaseX < phases_; ++phaseX) {
        std::vector<Tap>& taps = taps_.emplace_back();
        for (int dz = 0; dz < kReach; ++dz)
          for (int dy = 0; dy < kReach; ++dy)
            for (int dx = 0; dx < kReach; ++dx) {
              Tap tap{{}, (dz * kWindow + dy) * kReach + dx};
              bool reached = false;
              for (int y = 0; y < kBrickNodes; ++y)
                for (int x = 0; x < kBrickNodes; ++x) {
                  const Vec3 place((phaseX + x) % refine_, (phaseY + y) % refine_, z);
                  const Vec3 d = Vec3(dx - 1, dy - 1, dz - 1) - place / refine_;
                  const float weight = float(kernel(d.norm(), kSmoothingPerSpacing));
                  tap.weight[y * kBrickNodes + x] = weight;
                  reached = reached || weight > 0;
                }
              if (reached) taps.push_back(tap);
            }
      }
  for (int phaseZ = 0; phaseZ < phases_; ++phaseZ)
    for (int phaseY = 0; phaseY < phases_; ++phaseY)
      for (int phaseX = 0; phaseX < phases_; ++phaseX) {
        float* out = full_.data() + phaseIndex({phaseX, phaseY, phaseZ}) * kBrickSize;
        for (int z = 0; z < kBrickNodes; ++z)
          for (const Tap& tap : taps_[phaseIndex({phaseX, phaseY, (phaseZ + z) % refine_})])
            for (int i = 0; i < kBrickNodes * kBrickNodes; ++i)
              out[z * kBrickNodes * kBrickNodes + i] += 100.f * tap.weight[i];
      }
}

// Evaluates the planes of nodes named by the bits of `planes`, two planes that lie alike in their
// cells at a time. Every node adds its cells in the same order whatever its plane or brick; a tap
// that does not reach it adds an exact zero. Aims at a product and a sum per tap and eight nodes;
// the four sums of a pair of planes hide each other's latency.
RESECT_WIDEST
void ColourField::evaluate(const Vec3i& b, unsigned planes, float* out) const {
  const Vec3i first = phase(b);
  NodePlaces place;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < kBrickNodes; ++i) place[a][i] = (first[a] + i) / refine_;
  static_assert(kWindow == kMostRows && kReach == kAcross);
  CellTable tables[2];
  const float* low = cells_.data() + padded(windowCell(b));
  const std::ptrdiff_t alongY = paddedDims_.x(), alongZ = alongY * paddedDims_.y();
  switch (refine_) {
    case 1:
      gatherCells<1>(low, alongY, alongZ, place, tables);
      break;
    case 2:
      gatherCells<2>(low, alongY, alongZ, place, tables);
      break;
    case 4:
      gatherCells<4>(low, alongY, alongZ, place, tables);
      break;
    default:
      gatherCells<0>(low, alongY, alongZ, place, tables);
  }
  // What the two halves of plane z see.
  const auto seenBy = [&](int z, int half) {
    const int y = place[1][2 * half], step = place[1][2 * half + 1] - y;
    return &tables[step][place[2][z]][y][0];
  };
  for (int z = 0; z < kBrickNodes; ++z) {
    if (!(planes >> z & 1)) continue;
    // The next plane that lies alike; where there is none, the plane is its own partner.
    const int other = z + refine_ < kBrickNodes && (planes >> (z + refine_) & 1) ? z + refine_ : z;
    planes &= ~(1u << other);
    const Half *cells0 = seenBy(z, 0), *cells1 = seenBy(z, 1);
    const Half *cells2 = seenBy(other, 0), *cells3 = seenBy(other, 1);
    Half sum0 = {}, sum1 = {}, sum2 = {}, sum3 = {};
    for (const Tap& tap : taps_[phaseIndex({first.x(), first.y(), (first.z() + z) % refine_})]) {
      const Half* weight = halves(tap.weight);
      sum0 += cells0[tap.offset] * weight[0];
      sum1 += cells1[tap.offset] * weight[1];
      sum2 += cells2[tap.offset] * weight[0];
      sum3 += cells3[tap.offset] * weight[1];
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

}  // namespace resect
