// Which of n x n x n points lie inside a mesh? The question of row E, asked of us.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/inside_samples.h"

namespace resect::bench {

struct InsideGrid {
  Vec3 first, pitch;  // m
  int n = 0;

  Vec3 point(int x, int y, int z) const { return first + Vec3(x, y, z).cwiseProduct(pitch); }
  std::size_t index(int x, int y, int z) const { return (std::size_t(y) * n + x) * n + z; }
};

// Over the mesh's box with a margin of half a pitch.
InsideGrid gridRound(const TriangleMesh& mesh, int n);

// The stretches of points inside: what a peer's stencil or list of hits says, too.
InsideSamples insideSamples(const TriangleMesh& mesh, const InsideGrid& grid);

// One flag per point, z fastest.
std::vector<std::uint8_t> flagsOf(const InsideSamples& inside, const InsideGrid& grid);

// How far `theirs` is from `ours`: points that differ, and how many of those are farther than
// `tolerance` (m) from the surface.
struct FlagDifference {
  std::int64_t points = 0, offSurface = 0;
};
FlagDifference compareFlags(const TriangleMesh& mesh, const InsideGrid& grid,
                            const std::vector<std::uint8_t>& ours,
                            const std::vector<std::uint8_t>& theirs, double tolerance);

// Columns of the grid whose crossings do not come in pairs.
std::int64_t oddColumns(const TriangleMesh& mesh, const InsideGrid& grid);

}  // namespace resect::bench
