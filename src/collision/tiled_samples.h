// How are the steps of a grid's columns gathered in tiles and made stretches of points? For
// collision/inside_samples.cpp alone.
#pragma once

#include "collision/inside_samples.h"

namespace resect {

constexpr std::int32_t kMostPoints = 1 << 20;  // halves of them are exact in single precision

// Whether this machine has what tiles are tested with.
bool canTile();

// As insideSamples(). mesh: not empty; grid: with columns; line.count <= kMostPoints; canTile().
InsideSamples insideSamplesByTiles(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line);

}  // namespace resect
