// What a file held becomes the mesh of an organ: all checks and repairs of a sound liver.

#include "io/organ_mesh.h"

#include <benchmark/benchmark.h>

#include "organ/builtin/builtin_liver.h"

using namespace resect;

namespace {

void prepareLiver(benchmark::State& state) {
  const Model model{"liver", "", {{"", builtinLiver(1e-6 * double(state.range(0)))}}};
  state.counters["triangles"] = double(model.parts[0].mesh.triangles.size());
  for (auto _ : state) benchmark::DoNotOptimize(prepareOrganMesh(model, {}).health.volume);
}
BENCHMARK(prepareLiver)
    ->ArgName("edge_um")
    ->Arg(5000)
    ->Arg(900)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// To the child process's pipe and back.
void crossPipe(benchmark::State& state) {
  const Model model{"liver", "", {{"", builtinLiver(0.0009)}}};
  for (auto _ : state)
    benchmark::DoNotOptimize(bytesToModel(modelToBytes(model), "liver").parts.size());
}
BENCHMARK(crossPipe)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
