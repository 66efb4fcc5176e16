// Contacts of a rod on its way through the liver in one frame.

#include "tools/contacts.h"

#include <benchmark/benchmark.h>

#include "support/bench_organs.h"
#include "support/rod.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

// A rod moves 5 mm aside and turns by 2 degrees, deep in the organ.
void sweptContacts(benchmark::State& state) {
  const Organ organ = makeOrgan(bench::liverCells(double(state.range(0))), {});
  const StillTissue still(organ.rest.lattice, organ.alive);
  const auto rod = std::move(bench::rod().front());
  const Vec3 middle = bounds(bench::liver()).centre();
  const Pose from{middle, Eigen::Quaterniond::Identity()};
  const Pose to{middle + Vec3(0.005, 0, 0),
                Eigen::Quaterniond(Eigen::AngleAxisd(0.035, Vec3::UnitY()))};
  double touched = 0;
  for (auto _ : state) touched = double(findContacts(organ, still, *rod, from, to).cells.size());
  state.counters["touched"] = touched;
}
BENCHMARK(sweptContacts)->Apply(bench::upToAMillion)->Unit(benchmark::kMicrosecond);

}  // namespace
