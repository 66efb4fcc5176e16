// Which columns of a tile does a triangle cover, and between which points of a line along them does
// it cross each? Eight columns at a time in single precision, exactly where that is in doubt. For
// collision/tiled_samples.cpp, on machines with AVX2 and fused products.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/raw_array.h"
#include "collision/footprint.h"
#include "collision/grid_lines.h"
#include "collision/inside_samples.h"
#include "collision/step_tiles.h"
#include "collision/triangle_fours.h"

namespace resect {

class TileCaster {
 public:
  // Triangles that are sorted out together: their lists stay in the first cache.
  static constexpr std::size_t kRun = 512;

  // line.count: at most kMostPoints.
  TileCaster(const MeshOnGrid& placed, const SampleLine& line);

  // Adds the steps of triangles [begin, end).
  void cast(std::size_t begin, std::size_t end, StepTiles& tiles) const;

 private:
  std::int32_t pointsUpTo(double depth) const;
  void insert(const GridCell& at, double depth, std::int32_t sign, StepTiles& tiles) const;
  void castLone(const LoneColumn& lone, StepTiles& tiles) const;
  void castFiltered(const TriangleFour& four, std::size_t k, std::size_t triangle,
                    StepTiles& tiles) const;
  void castExactly(std::size_t triangle, StepTiles& tiles) const;
  // Of a triangle with an area.
  [[gnu::noinline]] void testExactly(std::size_t triangle, int tileRow, int tile,
                                     TileStep* steps) const;
  std::pair<int, int> tilesLeft(const TriangleFour& four, std::size_t k,
                                const float (&rows)[3]) const;

  const MeshOnGrid& placed_;
  SampleLine line_;
  double perPitch_;
  double slack_;                           // see slackOf()
  float highest_;                          // place beyond which all are behind the last point
  RawArray<std::int32_t> columns_, rows_;  // of each tile's lanes, on the raster
};

}  // namespace resect

#endif
