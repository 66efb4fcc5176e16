#include "peers/sampling.h"

#include <fmt/format.h>

#include "base/parallel.h"
#include "support/bench_organs.h"
#include "surface/surface_tracker.h"

namespace resect::bench {

Findings compareSampling(const Effort& effort, const SamplingPeer& peer) {
  constexpr int kPoints = 256;
  std::vector<double> sizes = {1e4, 1e5};
  if (!effort.quick) sizes.push_back(5e5);
  Findings findings;
  for (const double size : sizes) {
    const ColourField field(liverCells(particlesFor(size)), 2);
    const TriangleMesh mesh = SurfaceTracker(field, 50).mesh();
    const InsideGrid grid = gridRound(mesh, kPoints);
    for (const int threads : threadCounts()) {
      const ThreadLimit limit(threads);
      Comparison line;
      line.row = "E";
      line.work = fmt::format("{0} x {0} x {0} points inside or outside", kPoints);
      line.peer = peer.name;
      line.size = double(mesh.triangles.size());
      line.sizeUnit = "triangles";
      line.threads = threads;
      peer.prepare(mesh, grid, threads);
      peer.sample();
      const Crossings columns = castColumns(mesh, grid);
      const FlagDifference d =
          compareFlags(mesh, grid, flagsOf(columns, grid), peer.flags(), peer.tolerance);
      const std::int64_t odd = oddColumns(columns);
      line.agreement = fmt::format("{} points differ, {} of them off the surface; {} odd columns",
                                   d.points, d.offSurface, odd);
      line.agrees = d.offSurface == 0 && odd == 0;
      timeBoth([&] { countInside(mesh, grid); }, peer.sample, effort, line);
      findings.comparisons.push_back(std::move(line));
    }
  }
  return findings;
}

}  // namespace resect::bench
