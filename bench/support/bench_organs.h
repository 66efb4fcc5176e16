// Organs for the benchmarks: the built-in liver, at any number of particles.
#pragma once

#include <benchmark/benchmark.h>

#include "organ/discretize.h"

namespace resect::bench {

// Some 80 000 triangles; made once.
const TriangleMesh& liver();

// Spacing at which the liver has about that many particles, m.
double spacingFor(double particles);

Discretization liverCells(double particles);

// Particles at which the liver's surface, two nodes to a cell, has about that many triangles.
double particlesFor(double triangles);

// The `count` particles nearest to the liver's foremost point, ascending: a bite out of its skin,
// of the same shape in cells at every spacing.
std::vector<std::int64_t> bite(const Discretization& cells, int count);

// Edge of a blade held upright in tissue, `depth` under its top, that is drawn along +X and a
// little askew, so that it meets no node of the grid.
std::vector<Vec3> uprightEdge(const Vec3& top, double x, double depth);

// ->Apply(bench::atDepths): argument "depth_mm" of 10, 20 and 40, microseconds.
void atDepths(benchmark::internal::Benchmark* benchmark);

// ->Apply(bench::upToAMillion): argument "particles" of 10^4, 10^5 and 10^6, wall time.
void upToAMillion(benchmark::internal::Benchmark* benchmark);
// The same with a second argument "refine", nodes per cell: 1 and 2.
void upToAMillionOfNodes(benchmark::internal::Benchmark* benchmark);

}  // namespace resect::bench
