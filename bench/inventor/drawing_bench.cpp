// Cost of a picture of the operating room, and of its parts.
//
// The built-in liver at 8 mm, three instruments, the surgeon's view. "still" draws the same scene
// again; "tool moves" makes the shadows anew too. "operating" is what a window does at 5 mm, with
// moving tissue at 8 mm: the operation goes on in its thread, the picture follows it; what the time
// per picture allows is how often it is shown. "process" CPU counts all threads, the operation's
// too.

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <benchmark/benchmark.h>

#include "inventor/gl/camera_moves.h"
#include "inventor/hand/operating_session.h"
#include "inventor/picture/live_picture.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operation_view.h"
#include "io/operation_setup.h"
#include "operation/room.h"
#include "tools/registry.h"

namespace resect {
namespace {

Scenario liverAndTools(double spacing, bool elastic) {
  Scenario scenario;
  scenario.organs[0].source.spacing = spacing;
  if (elastic) makeElastic(scenario);
  int place = 0;
  for (const ToolKind& kind : toolKinds())
    scenario.tools.push_back({std::string(kind.name), {}, toolBoxPlace(place++), {}});
  return scenario;
}

const ModelReader kReader = [](const std::filesystem::path& p, const std::string& parts) {
  return readModel(p, parts);
};

void drawing(benchmark::State& state, bool moves) {
  const Scenario scenario = liverAndTools(0.008, false);
  Simulation simulation(makeOrgan(loadCells(scenario.organs[0].source, kReader), {}),
                        loadTools(scenario, kReader));
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

enum class Doing { Waving, Cutting, Turning, Elastic };

// A scalpel goes to and fro over the liver or through it; the camera turns; the tissue moves.
void operating(benchmark::State& state, Doing doing) {
  const Scenario scenario =
      liverAndTools(doing == Doing::Elastic ? 0.008 : 0.005, doing == Doing::Elastic);
  constexpr int kWidth = 1280, kHeight = 720;
  std::vector<std::uint32_t> window(std::size_t(kWidth) * kHeight);
  Organ organ =
      makeOrgan(loadCells(scenario.organs[0].source, kReader), scenario.organs[0].source.settings);
  auto tissue = makeTissue(scenario.organs[0].tissue, organ);
  OperatingSession session(scenario,
                           std::make_unique<Simulation>(
                               std::move(organ), loadTools(scenario, kReader), std::move(tissue)),
                           16.0 / 9);
  LivePicture picture;
  const auto draw = [&] {
    const Damage damage = session.update();
    session.room().holdShadows(!picture.shadowsAreDue(damage));
    for (const PixelRect& part :
         picture.draw(session.root(), *session.room().camera(), damage, SbVec2s(kWidth, kHeight)))
      picture.read(part, &window[std::size_t(kHeight - part.top) * kWidth + part.left], kWidth);
  };
  session.room().setShadowResolution(512);
  session.operation().waitFor(3);
  draw();
  const Aabb box = session.cells().lattice.box();
  session.tools().take(0);
  const Pose ready = session.tools().pose(0);
  double pixels = 0, scale = 0, phase = 0;
  for (auto _ : state) {
    phase += 0.03;
    if (doing == Doing::Turning) {
      SbRotation turn(SbVec3f(0, 1, 0), 0.01f);
      SoPerspectiveCamera& camera = *session.room().camera();
      SbVec3f at;
      turn.multVec(camera.position.getValue(), at);
      camera.position = at;
      camera.orientation = camera.orientation.getValue() * turn;
      picture.forget();
    } else {
      const double depth = doing == Doing::Waving ? 0.03 : -0.012 - 0.004 * std::floor(phase / 3);
      const Vec3 tip(box.centre().x() + 0.35 * box.size().x() * std::sin(phase),
                     box.max.y() + depth,
                     box.centre().z() + 0.02 * std::floor(std::fmod(phase, 9) / 3));
      session.tools().setPose(0, {tip, ready.rotation});
    }
    draw();
    pixels += double(picture.drawnPixels());
    scale += picture.scale();
  }
  state.counters["pixels"] = benchmark::Counter(pixels, benchmark::Counter::kAvgIterations);
  state.counters["scale"] = benchmark::Counter(scale, benchmark::Counter::kAvgIterations);
  state.counters["removed"] = double(session.state().removed);
  state.counters["realtime"] = session.state().times.realTimeFactor;
}
BENCHMARK_CAPTURE(operating, tool_waves, Doing::Waving)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(operating, tool_cuts, Doing::Cutting)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(operating, camera_turns, Doing::Turning)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(operating, tissue_moves, Doing::Elastic)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

BENCHMARK_CAPTURE(drawing, still, false)
    ->ArgNames({"width", "samples"})
    ->ArgsProduct({{320, 640, 1280}, {1}})
    ->Args({1280, 4})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(drawing, tool_moves, true)
    ->ArgNames({"width", "samples"})
    ->ArgsProduct({{320, 640, 1280}, {1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace resect

BENCHMARK_MAIN();
