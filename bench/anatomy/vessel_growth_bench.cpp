// Growth of the built-in liver's vessels, and its parts; range: terminals of each kind.

#include "anatomy/growth/vessel_growth.h"

#include <benchmark/benchmark.h>

#include "anatomy/growth/triads.h"
#include "anatomy/measure_anatomy.h"
#include "organ/builtin/builtin_liver.h"

using namespace resect;

namespace {

VesselGrowth settings(const benchmark::State& state) {
  VesselGrowth growth = builtinLiverVessels();
  growth.terminals = int(state.range(0));
  return growth;
}

void growAllVessels(benchmark::State& state) {
  const TriangleMesh liver = builtinLiver();
  for (auto _ : state) benchmark::DoNotOptimize(growVessels(liver, settings(state)));
}
BENCHMARK(growAllVessels)->Arg(200)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond);

void distancesInside(benchmark::State& state) {
  const TriangleMesh liver = builtinLiver();
  for (auto _ : state) benchmark::DoNotOptimize(OrganInside(liver).depthAt(0));
}
BENCHMARK(distancesInside)->Unit(benchmark::kMillisecond);

// Artery and duct beside the portal vein.
void growTriads(benchmark::State& state) {
  const TriangleMesh liver = builtinLiver();
  const OrganInside inside(liver);
  std::vector<VesselSegment> veins = growVessels(liver, settings(state)).segments;
  std::erase_if(veins, [](const VesselSegment& s) {
    return s.kind == VesselKind::HepaticArtery || s.kind == VesselKind::BileDuct;
  });
  for (auto _ : state) {
    std::vector<VesselSegment> all = veins;
    addTriads(all, settings(state), inside);
    benchmark::DoNotOptimize(all.data());
  }
}
BENCHMARK(growTriads)->Arg(200)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond);

void measureVessels(benchmark::State& state) {
  const TriangleMesh liver = builtinLiver();
  const Anatomy anatomy = growVessels(liver, settings(state));
  for (auto _ : state) benchmark::DoNotOptimize(measure(anatomy, liver));
}
BENCHMARK(measureVessels)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
