// Layered depth images: all crossings of n x n columns with the liver's 80 000 triangles.

#include "collision/columns.h"

#include <benchmark/benchmark.h>

#include "support/bench_organs.h"

using namespace resect;

namespace {

void layeredDepthImage(benchmark::State& state) {
  const TriangleMesh& mesh = bench::liver();
  const int n = int(state.range(0));
  const Aabb box = bounds(mesh);
  const Vec2 pitch = box.size().head<2>() / n;
  double crossings = 0;
  for (auto _ : state) {
    const SnappedMesh snapped = snapToRaster(mesh);
    crossings =
        double(castColumns(snapped, {box.min.head<2>() + 0.5 * pitch, pitch, n, n}).all.size());
  }
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["crossings"] = crossings;
}
BENCHMARK(layeredDepthImage)
    ->ArgName("columns")
    ->Arg(64)
    ->Arg(256)
    ->Arg(1024)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
