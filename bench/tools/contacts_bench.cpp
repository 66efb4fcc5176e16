// Which particles does a rod touch on its way through the liver in one frame?

#include "tools/contacts.h"

#include <benchmark/benchmark.h>

#include "geometry/primitives.h"
#include "support/bench_organs.h"
#include "tools/registry.h"

using namespace resect;

namespace {

// A rod 10 mm across and 0.2 m long moves 5 mm aside and turns by 2 degrees, deep in the organ.
void sweptContacts(benchmark::State& state) {
  const Organ organ = makeOrgan(bench::liverCells(double(state.range(0))), {});
  ToolModel model;
  model.name = model.kind = "baton";
  model.mesh = sphereMesh({0, 0, 0.1}, 1, 12);
  for (Vec3& p : model.mesh.points) p = (p - Vec3(0, 0, 0.1)).cwiseProduct(Vec3(0.005, 0.005, 0.1));
  const auto rod = makeTool(std::move(model));
  const Vec3 middle = bounds(bench::liver()).centre();
  const Pose from{middle, Eigen::Quaterniond::Identity()};
  const Pose to{middle + Vec3(0.005, 0, 0),
                Eigen::Quaterniond(Eigen::AngleAxisd(0.035, Vec3::UnitY()))};
  double touched = 0;
  for (auto _ : state) touched = double(findContacts(organ, *rod, 0, from, to).cells.size());
  state.counters["touched"] = touched;
}
BENCHMARK(sweptContacts)->Apply(bench::upToAMillion)->Unit(benchmark::kMicrosecond);

}  // namespace
