// Exact columns: 500 000 triangles at 256 x 256 columns; 256^3 points of a grid; points asked
// directly; a tool swept through points; an organ of 20 000 triangles against a tool through the
// three stages of the collider.
#include <benchmark/benchmark.h>

#include "base/random.h"
#include "collision/collider.h"
#include "collision/columns.h"
#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "support/bench_organs.h"
#include "surface/surface_tracker.h"

namespace resect {
namespace {

// Tilted, so that nothing lies along the columns.
TriangleMesh ball(int rings) {
  return transformed(sphereMesh({0, 0, 0}, 0.1, rings),
                     {{0, 0, 0}, Eigen::Quaterniond(0.8, 0.3, 0.2, 0.1).normalized()});
}

std::vector<Vec3> randomPoints(int count) {
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                        random.uniform(-0.1, 0.1));
  return points;
}

void castHalfAMillionTriangles(benchmark::State& state) {
  const TriangleMesh mesh = ball(354);
  const double pitch = 0.2 / 256;
  const Vec2 first(-0.1 + pitch / 2, -0.1 + pitch / 2);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        castColumns(snapToRaster(mesh), ColumnGrid{first, {pitch, pitch}, 256, 256}));
  state.counters["triangles"] = double(mesh.triangles.size());
}
BENCHMARK(castHalfAMillionTriangles)->Unit(benchmark::kMillisecond)->UseRealTime();

// Snapping included, as row E of docs/performance.md has it.
std::int64_t countInside(const TriangleMesh& mesh, const Vec3& first, const Vec3& pitch) {
  const Crossings columns =
      castColumns(snapToRaster(mesh), ColumnGrid{first.head<2>(), pitch.head<2>(), 256, 256});
  std::int64_t inside = 0;
  for (std::size_t c = 0; c < columns.columnCount(); ++c)
    forEachInside(columns[c], {first.z(), pitch.z(), 256},
                  [&](int begin, int end) { inside += end - begin; });
  return inside;
}

void pointsOfAGrid(benchmark::State& state) {
  const TriangleMesh mesh = ball(int(state.range(0)));
  const Vec3 pitch = Vec3::Constant(0.2 / 256), first = Vec3::Constant(-0.1) + 0.5 * pitch;
  for (auto _ : state) benchmark::DoNotOptimize(countInside(mesh, first, pitch));
  state.counters["triangles"] = double(mesh.triangles.size());
}
BENCHMARK(pointsOfAGrid)->ArgName("rings")->Arg(50)->Arg(354)->Unit(benchmark::kMillisecond);

// The same of the liver that row E has, which many columns cross four times.
void pointsOfALiver(benchmark::State& state) {
  const ColourField field(bench::liverCells(bench::particlesFor(double(state.range(0)))), 2);
  const TriangleMesh mesh = SurfaceTracker(field, 50).mesh();
  const Aabb box = bounds(mesh);
  const Vec3 pitch = box.size() / 256, first = box.min + 0.5 * pitch;
  for (auto _ : state) benchmark::DoNotOptimize(countInside(mesh, first, pitch));
  state.counters["triangles"] = double(mesh.triangles.size());
}
BENCHMARK(pointsOfALiver)
    ->ArgName("triangles")
    ->Arg(10'000)
    ->Arg(500'000)
    ->Unit(benchmark::kMillisecond);

void askHundredThousandPoints(benchmark::State& state) {
  const TriangleMesh mesh = ball(70);
  const std::vector<Vec3> points = randomPoints(100'000);
  for (auto _ : state) benchmark::DoNotOptimize(insideFlags(mesh, points));
}
BENCHMARK(askHundredThousandPoints)->Unit(benchmark::kMillisecond)->UseRealTime();

void sweepThroughThirteenThousandPoints(benchmark::State& state) {
  const TriangleMesh tool = sphereMesh({0, 0, 0}, 0.01, 12);
  const std::vector<Vec3> points = randomPoints(13'000);
  const Pose from{{0.05, 0, 0}, Eigen::Quaterniond::Identity()};
  const double turn = state.range(0) ? 0.1 : 0;
  const Pose to{{0.05, 0.01, 0.005}, Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitX()))};
  for (auto _ : state) benchmark::DoNotOptimize(sweptInside(tool, from, to, points));
  state.SetLabel(state.range(0) ? "turning" : "straight");
}
BENCHMARK(sweepThroughThirteenThousandPoints)
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void collideToolWithOrgan(benchmark::State& state) {
  const TriangleMesh organ = ball(71), tool = sphereMesh({0.1, 0, 0}, 0.02, 12);
  const Aabb common = intersection(bounds(organ), bounds(tool));
  const ColumnGrid pixels = pixelsOver(common, 64);
  for (auto _ : state)
    benchmark::DoNotOptimize(volume(intersectionVolume(layeredDepthImage(organ, common, pixels),
                                                       layeredDepthImage(tool, common, pixels))));
}
BENCHMARK(collideToolWithOrgan)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace resect
