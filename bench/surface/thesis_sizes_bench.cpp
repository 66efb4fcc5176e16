// One surface update at the thesis's two sizes, by its method and by ours, in one run.
//
// Plain: every node of its grid sums over all particles, marching cubes over all cells
// (test/support/references/thesis_method.h). Ours: the cells that a tool removes are set, the
// bricks in their reach are evaluated and meshed, with normals, as the plain method makes them too;
// then the same cells come back, and so on in turn, so that every update does the same work. The
// tool is a rod straight through the built-in liver.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "organ/organ.h"
#include "support/bench_organs.h"
#include "support/references/thesis_method.h"

using namespace resect;

namespace {

struct Size {
  const char* name;
  int particles;                // about
  int gridNodes;                // of the thesis's marching cubes, along each axis
  double thesisSecondsPerNode;  // on its Pentium III, 500 MHz
};
constexpr Size kSmall{"thesis_120_particles", 120, 20, 27.9e-6};
constexpr Size kLarge{"thesis_950_particles", 950, 30, 0.12e-3};

// Particles whose centre lies within 0.7 spacings of the line along z through the organ's middle.
std::vector<std::int64_t> particlesOnTool(const Discretization& cells) {
  const Lattice& lattice = cells.lattice;
  const Vec3 middle = 0.5 * (lattice.dims - Vec3i::Ones()).cast<double>();
  std::vector<std::int64_t> found;
  for (std::int64_t i = 0; i < lattice.cellCount(); ++i)
    if (cells.inside[i] && (lattice.cell(i).cast<double>() - middle).head<2>().norm() < 0.71)
      found.push_back(i);
  return found;
}

void plain(benchmark::State& state, Size size, bool passOverFar) {
  const Discretization cells = bench::liverCells(size.particles);
  const Lattice& lattice = cells.lattice;
  std::vector<test::ThesisParticle> particles;
  std::vector<std::int32_t> numberOf(std::size_t(lattice.cellCount()), -1);
  for (std::int64_t i = 0; i < lattice.cellCount(); ++i)
    if (cells.inside[i]) {
      numberOf[i] = std::int32_t(particles.size());
      particles.push_back({lattice.centre(lattice.cell(i)), lattice.cellVolume(), 100});
    }
  const std::vector<std::int64_t> onTool = particlesOnTool(cells);
  test::ThesisMethod thesis({lattice.box(), Vec3i::Constant(size.gridNodes)},
                            kSmoothingPerSpacing * lattice.spacing.x(), 50);
  double colour = 100;
  std::size_t triangles = 0;
  StageClock clock;
  for (auto _ : state) {
    colour = 100 - colour;
    for (const std::int64_t cell : onTool) particles[numberOf[cell]].colour = colour;
    const test::ThesisSurface surface = thesis.update(particles, passOverFar, &clock);
    triangles = surface.mesh.triangles.size();
    benchmark::DoNotOptimize(surface.normals.data());
  }
  double whole = 0;
  for (const StageTimes& function : clock.stages()) whole += summarise(function.seconds).total;
  for (const StageTimes& function : clock.stages())
    state.counters["% " + function.name] = 100 * summarise(function.seconds).total / whole;
  const double nodes = double(thesis.grid().count());
  state.counters["per node"] = benchmark::Counter(
      nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetLabel(fmt::format("{} particles, {} nodes, {} triangles; the thesis: {:.2f} s",
                             particles.size(), thesis.grid().count(), triangles,
                             nodes * size.thesisSecondsPerNode));
}

void resectUpdate(benchmark::State& state, Size size) {
  Organ organ = makeOrgan(bench::liverCells(size.particles), {});
  struct Edit {
    std::int64_t cell;
    float value;
  };
  std::vector<Edit> edits;  // the particles on the tool, each with the skin cells that go with it
  const std::vector<std::int64_t> onTool = particlesOnTool(organ.rest);
  for (std::int64_t i = 0; i < organ.rest.lattice.cellCount(); ++i)
    if (organ.rest.value[i] > 0 && std::ranges::count(onTool, ownerCell(organ.rest, i)))
      edits.push_back({i, organ.rest.value[i]});
  bool removed = false;
  for (auto _ : state) {
    removed = !removed;
    for (const Edit& edit : edits) organ.field.setCellValue(edit.cell, removed ? 0 : edit.value);
    updateSurface(organ, updateField(organ));
    organ.surface.updateLook(organ.field);
  }
  const double bricks = double(organ.surface.changes().bricks);
  state.counters["per brick"] = benchmark::Counter(
      bricks, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetLabel(fmt::format(
      "{} particles, {} nodes, {} triangles; {} particles removed or restored, {} bricks anew",
      organ.particles, std::int64_t(organ.field.nodeDims().prod()), organ.surface.triangleCount(),
      onTool.size(), bricks));
}

// The same surface from scratch: what keeping nothing would cost us.
void resectRebuild(benchmark::State& state, Size size) {
  const Discretization cells = bench::liverCells(size.particles);
  for (auto _ : state) {
    const ColourField field(cells, 2);
    SurfaceTracker surface(field, 50);
    surface.updateLook(field);
    benchmark::DoNotOptimize(surface.triangleCount());
  }
}

void settings(benchmark::internal::Benchmark* b) {
  b->UseRealTime()->Unit(benchmark::kMicrosecond)->Repetitions(9)->DisplayAggregatesOnly();
}

const int registered = [] {
  for (const Size& size : {kSmall, kLarge}) {
    const std::string name = size.name;
    settings(benchmark::RegisterBenchmark((name + "/plain").c_str(), plain, size, false));
    settings(benchmark::RegisterBenchmark((name + "/resect").c_str(), resectUpdate, size));
    settings(benchmark::RegisterBenchmark((name + "/plain_passing_over_far").c_str(), plain, size,
                                          true));
    settings(
        benchmark::RegisterBenchmark((name + "/resect_from_scratch").c_str(), resectRebuild, size));
  }
  return 0;
}();

}  // namespace
