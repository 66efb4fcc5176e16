// What does a picture of the operating room cost, and which part of it?
//
// The built-in liver at 8 mm, three instruments, the surgeon's view. "still" draws the same scene
// again; "tool moves" makes the shadows anew too.

#include <benchmark/benchmark.h>

#include "inventor/model_file.h"
#include "inventor/offscreen_view.h"
#include "inventor/operation_view.h"
#include "io/operation_setup.h"
#include "operation/room.h"
#include "tools/registry.h"

namespace resect {
namespace {

void drawing(benchmark::State& state, bool moves) {
  Scenario scenario;
  scenario.organ.spacing = 0.008;
  int place = 0;
  for (const ToolKind& kind : toolKinds())
    scenario.tools.push_back({std::string(kind.name), {}, toolBoxPlace(place++), {}});
  const ModelReader reader = [](const std::filesystem::path& p) { return readModel(p); };
  Simulation simulation(makeOrgan(loadCells(scenario.organ, reader), {}),
                        loadTools(scenario, reader));
  const int width = int(state.range(0)), height = width * 9 / 16, samples = int(state.range(1));
  OffscreenView picture(width, height, samples);
  OperationView view(scenario, simulation, 16.0 / 9);
  view.draw(picture);
  double x = 0;
  for (auto _ : state) {
    if (moves) view.room().setToolPose(0, {Vec3(0.02 * std::sin(x += 0.1), 0.2, 0), {1, 0, 0, 0}});
    benchmark::DoNotOptimize(view.draw(picture));
  }
  state.SetLabel(picture.renderer());
}

BENCHMARK_CAPTURE(drawing, still, false)
    ->ArgNames({"width", "samples"})
    ->ArgsProduct({{320, 640, 1280}, {1}})
    ->Args({1280, 4})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(drawing, tool_moves, true)
    ->ArgNames({"width", "samples"})
    ->ArgsProduct({{320, 640, 1280}, {1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace resect

BENCHMARK_MAIN();
