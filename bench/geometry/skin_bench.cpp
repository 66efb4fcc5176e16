// A surface that was read becomes the skin of a body: welded, examined, laid on the table.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "geometry/repair/mesh_health.h"
#include "geometry/repair/weld.h"
#include "geometry/resting_pose.h"
#include "geometry/topology.h"
#include "organ/builtin/builtin_liver.h"

using namespace resect;

namespace {

// The liver in triangles of 5 and 0.9 mm: 1.5 x 10^4 and 5 x 10^5 of them.
void ofSizes(benchmark::internal::Benchmark* b) {
  b->ArgName("edge_um")->Arg(5000)->Arg(900)->Unit(benchmark::kMillisecond)->UseRealTime();
}

TriangleMesh liver(benchmark::State& state) {
  TriangleMesh mesh = builtinLiver(1e-6 * double(state.range(0)));
  state.counters["triangles"] = double(mesh.triangles.size());
  return mesh;
}

void weldIndexed(benchmark::State& state) {
  const TriangleMesh mesh = liver(state);
  for (auto _ : state) benchmark::DoNotOptimize(weld(mesh).triangles.size());
}
BENCHMARK(weldIndexed)->Apply(ofSizes);

// Every triangle with corners of its own, as STL has them.
void weldSoup(benchmark::State& state) {
  const TriangleMesh mesh = liver(state);
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto n = std::int32_t(soup.points.size());
    for (const std::int32_t i : t) soup.points.push_back(mesh.points[i]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  for (auto _ : state) benchmark::DoNotOptimize(weld(soup).triangles.size());
}
BENCHMARK(weldSoup)->Apply(ofSizes);

void edgesAndPieces(benchmark::State& state) {
  const TriangleMesh mesh = liver(state);
  for (auto _ : state) benchmark::DoNotOptimize(topology(mesh).components);
}
BENCHMARK(edgesAndPieces)->Apply(ofSizes);

void examineSkin(benchmark::State& state) {
  const TriangleMesh mesh = liver(state);
  for (auto _ : state) benchmark::DoNotOptimize(examine(mesh).volume);
}
BENCHMARK(examineSkin)->Apply(ofSizes);

void layToRest(benchmark::State& state) {
  const TriangleMesh mesh = liver(state);
  for (auto _ : state) benchmark::DoNotOptimize(restingRotation(mesh).w());
}
BENCHMARK(layToRest)->Apply(ofSizes);

}  // namespace
