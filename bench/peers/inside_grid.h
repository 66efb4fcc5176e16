// Inside tests of n x n x n points (row E), by Resect.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/columns.h"

namespace resect::bench {

struct InsideGrid {
  Vec3 first, pitch;  // m
  int n = 0;

  Vec3 point(int x, int y, int z) const { return first + Vec3(x, y, z).cwiseProduct(pitch); }
  std::size_t index(int x, int y, int z) const { return (std::size_t(y) * n + x) * n + z; }
};

// Over the mesh's box with a margin of half a pitch.
InsideGrid gridRound(const TriangleMesh& mesh, int n);

// The columns' crossings, sorted: what a peer's stencil or list of hits says, too.
Crossings castColumns(const TriangleMesh& mesh, const InsideGrid& grid);

// How many points lie inside, by their stretches: what is timed.
std::int64_t countInside(const TriangleMesh& mesh, const InsideGrid& grid);

// One flag per point, z fastest.
std::vector<std::uint8_t> flagsOf(const Crossings& columns, const InsideGrid& grid);

// How far `theirs` is from `ours`: points that differ, and how many of those are farther than
// `tolerance` (m) from the surface.
struct FlagDifference {
  std::int64_t points = 0, offSurface = 0;
};
FlagDifference compareFlags(const TriangleMesh& mesh, const InsideGrid& grid,
                            const std::vector<std::uint8_t>& ours,
                            const std::vector<std::uint8_t>& theirs, double tolerance);

// Columns whose crossings do not come in pairs.
std::int64_t oddColumns(const Crossings& columns);

}  // namespace resect::bench
