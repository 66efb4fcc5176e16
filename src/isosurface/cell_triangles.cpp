#include "isosurface/cell_triangles.h"

#include <bit>

#include "base/instruction_set.h"
#include "isosurface/marching_cubes_table.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace resect {
namespace {

constexpr int edgeIndex(int axis, int node) {
  return EdgeTable::index(axis, node & 3, node >> 2 & 3, node >> 4);
}

// Offset in the table from a cell's first edge along an axis to each of its edges.
constexpr std::array<std::uint8_t, 12> kStepTo = [] {
  std::array<std::uint8_t, 12> steps{};
  for (std::size_t e = 0; e < 12; ++e) {
    const CellEdge& edge = kCellEdges[e];
    steps[e] = std::uint8_t(
        EdgeTable::index(edge.axis, edge.from & 1, edge.from >> 1 & 1, edge.from >> 2) -
        EdgeTable::index(edge.axis, 0, 0, 0));
  }
  return steps;
}();

}  // namespace

int EdgeTable::ofCell(int cell, int edge) {
  return edgeIndex(edge / 4, cell) + kStepTo[std::size_t(edge)];
}

Triangle* drawCellsPlainly(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                           Triangle* out) {
  const auto& drawnIn = marchingCubesTable();
  for (; cells != 0; cells &= cells - 1) {
    const int cell = std::countr_zero(cells);
    const CellTriangles& drawn = drawnIn[kinds[std::size_t(cell)]];
    for (std::size_t t = 0; t < drawn.count; ++t, ++out)
      for (std::size_t v = 0; v < 3; ++v)
        (*out)[v] = table.vertex[std::size_t(EdgeTable::ofCell(cell, drawn.edges[t][v]))];
  }
  return out;
}

#if defined(__x86_64__)

namespace {

// For each cell the table index of its first edge along x and along y; along z it is one axis block
// further than along y.
constexpr auto kFirstEdges = [] {
  std::array<std::array<std::uint16_t, 2>, kBrickSize> indices{};
  for (int cell = 0; cell < kBrickSize; ++cell)
    indices[std::size_t(cell)] = {std::uint16_t(edgeIndex(0, cell)),
                                  std::uint16_t(edgeIndex(1, cell))};
  return indices;
}();

// Loads two neighbouring entries, and the two a row or plane further.
RESECT_AVX2 inline __m128i fourEdges(const std::int32_t* first, int further) {
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(first));
  return _mm_castps_si128(
      _mm_loadh_pi(_mm_castsi128_ps(low), reinterpret_cast<const __m64*>(first + further)));
}

// A cell has up to five triangles, 15 corners: all are written, and the next cell overwrites the
// surplus. Aims at 32 instructions a cell, branch-free.
RESECT_AVX2 Triangle* drawCellsWide(const EdgeTable& table, const CellKinds& kinds,
                                    std::uint64_t cells, Triangle* out, const Triangle* limit) {
  static_assert(sizeof(CellTriangles) == 16 && sizeof(Triangle) == 12);
  constexpr int kRow = EdgeTable::kSpan, kPlane = kRow * kRow, kMost = 5;
  const CellTriangles* drawnIn = marchingCubesTable().data();
  for (; cells != 0 && limit - out >= kMost; cells &= cells - 1) {
    const auto cell = std::size_t(std::countr_zero(cells));
    const CellTriangles& drawn = drawnIn[kinds[cell]];
    const auto* corners = reinterpret_cast<const std::uint8_t*>(drawn.edges.data());
    const std::int32_t *alongX = table.vertex.data() + kFirstEdges[cell][0],
                       *alongY = table.vertex.data() + kFirstEdges[cell][1];
    const __m256i xy = _mm256_inserti128_si256(_mm256_castsi128_si256(fourEdges(alongX, kPlane)),
                                               fourEdges(alongY, kPlane), 1),
                  z = _mm256_castsi128_si256(fourEdges(alongY + EdgeTable::kAxis, kRow));
    // Eight corners from `first` on: edges 0 to 7 come from xy, 8 to 11 from z.
    const auto write = [&](int first) RESECT_AVX2 {
      const __m256i edges =
          _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(corners + first)));
      const __m256i numbers = _mm256_castps_si256(
          _mm256_blendv_ps(_mm256_castsi256_ps(_mm256_permutevar8x32_epi32(xy, edges)),
                           _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(z, edges)),
                           _mm256_castsi256_ps(_mm256_slli_epi32(edges, 28))));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(out->data() + first), numbers);
    };
    write(0);
    write(7);
    out += drawn.count;
  }
  return drawCellsPlainly(table, kinds, cells, out);
}

}  // namespace

Triangle* drawCells(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                    Triangle* out, const Triangle* limit) {
  static const bool wide = __builtin_cpu_supports("avx2");
  return wide ? drawCellsWide(table, kinds, cells, out, limit)
              : drawCellsPlainly(table, kinds, cells, out);
}

#else

Triangle* drawCells(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                    Triangle* out, const Triangle*) {
  return drawCellsPlainly(table, kinds, cells, out);
}

#endif

}  // namespace resect
