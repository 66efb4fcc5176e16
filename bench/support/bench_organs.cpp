#include "support/bench_organs.h"

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"
#include "organ/builtin/builtin_liver.h"
#include "surface/surface_tracker.h"

namespace resect::bench {

const TriangleMesh& liver() {
  static const TriangleMesh mesh = builtinLiver();
  return mesh;
}

double spacingFor(double particles) { return std::cbrt(volume(liver()) / particles); }

Discretization liverCells(double particles) {
  return discretize(liver(), latticeForSpacing(bounds(liver()), spacingFor(particles)));
}

double particlesFor(double triangles) {
  double particles = 0.4 * std::pow(triangles, 1.5) / 100;
  for (int i = 0; i < 3; ++i) {
    const ColourField field(liverCells(particles), 2);
    particles *= std::pow(triangles / double(SurfaceTracker(field, 50).triangleCount()), 1.5);
  }
  return particles;
}

std::vector<std::int64_t> bite(const Discretization& cells, int count) {
  Vec3 foremost = liver().points[0];
  for (const Vec3& p : liver().points)
    if (p.z() > foremost.z()) foremost = p;
  struct Candidate {
    double distance;
    std::int64_t cell;
    auto operator<=>(const Candidate&) const = default;
  };
  std::vector<Candidate> candidates;
  const Lattice& lattice = cells.lattice;
  for (std::int64_t i = 0; i < lattice.cellCount(); ++i)
    if (cells.inside[i])
      candidates.push_back({(lattice.centre(lattice.cell(i)) - foremost).norm(), i});
  const std::size_t taken = std::min(candidates.size(), std::size_t(count));
  std::partial_sort(candidates.begin(), candidates.begin() + taken, candidates.end());
  std::vector<std::int64_t> found;
  for (std::size_t i = 0; i < taken; ++i) found.push_back(candidates[i].cell);
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Vec3> uprightEdge(const Vec3& top, double x, double depth) {
  const double z = 0.1 * x + 0.0003;
  return {top + Vec3(x, -depth, z), top + Vec3(x, 0.02, z)};
}

void atDepths(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("depth_mm")->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);
}

void upToAMillionOfNodes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"particles", "refine"})
      ->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 2}})
      ->UseRealTime();
}

void upToAMillion(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("particles")->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->UseRealTime();
}

}  // namespace resect::bench
