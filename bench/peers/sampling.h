// The cases of row E, the same for every peer: which of 256^3 points lie inside the liver's
// surface?
#pragma once

#include <functional>

#include "peers/inside_grid.h"
#include "peers/rows.h"
#include "peers/timing.h"

namespace resect::bench {

// One peer: made ready for a mesh, it answers flags like insideFlags(). `threads`: that it may use.
struct SamplingPeer {
  std::string name;
  double tolerance;  // m: where it rounds, points that near to the surface may differ
  std::function<void(const TriangleMesh& mesh, const InsideGrid& grid, int threads)> prepare;
  std::function<void()> sample;  // what is timed
  std::function<std::vector<std::uint8_t>()> flags;
};

Findings compareSampling(const Effort& effort, const SamplingPeer& peer);

}  // namespace resect::bench
