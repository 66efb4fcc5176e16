// How are the steps of a grid's columns gathered, triangle by triangle, and made stretches of
// points? For collision/inside_samples.cpp alone.
#pragma once

#include "collision/inside_samples.h"

namespace resect {

// Points of a line, at most: steps take 15 bits, one of them for a sign; and of more points single
// precision leaves too many in doubt.
constexpr std::int32_t kMostPoints = (1 << 14) - 1;

// Whether this machine has what spans are found with.
bool canFindSpans();

// As insideSamples(). mesh: not empty, below 2^31 triangles; grid: with columns, at most 2^25;
// line.count
// <= kMostPoints; canFindSpans().
InsideSamples insideSamplesBySpans(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line);

}  // namespace resect
