// Most triangles of a fine mesh reach no column of the grid, or a single one. Which are they, which
// of those does it cross, and at which point of a line? In single precision; what that leaves in
// doubt is told apart. For collision/span_caster.cpp alone, on machines with AVX2 and fused
// products.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <cstdint>

#include "collision/inside_samples.h"
#include "collision/rough_mesh.h"
#include "collision/step_rows.h"

namespace resect {

// Triangles that are sorted out together: their lists stay in the first cache.
constexpr std::size_t kRun = 512;

// A run of triangles, by what they may cover; those that cover nothing are in none of the lists.
struct SortedRun {
  static constexpr std::size_t kRoom = kRun + 8;  // eight at a time are written

  // Those that cover the one column that they reach, and what the edge functions are there.
  std::size_t lone = 0;
  std::int32_t triangle[kRoom], column[kRoom], row[kRoom];
  float v1[kRoom], v2[kRoom], perArea[kRoom];  // perArea: below 0 if the face looks down
  // Those that may cover the one column that they reach.
  std::size_t unsure = 0;
  std::int32_t doubtful[kRoom];
  // Those that reach more columns.
  std::size_t others = 0;
  std::int32_t larger[kRoom];
};

// Of triangles [begin, end), at most kRun.
void sortOutRoughly(const RoughMesh& mesh, std::size_t begin, std::size_t end, SortedRun& run);

// The steps of the lone ones, or kNoStep where that is in doubt; room for eight more. lineSlack:
// see slackOf().
void findSteps(const RoughMesh& mesh, const SampleLine& line, double lineSlack,
               const SortedRun& run, Step* steps);

}  // namespace resect

#endif
