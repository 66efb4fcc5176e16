// H and I: what there is no peer for. Memory of an organ of a million particles, and the time of
// the frames when it is cut.

#include <fmt/format.h>

#include <algorithm>

#include "base/parallel.h"
#include "inventor/reading/model_file.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/scenario/scenario_file.h"
#include "operation/bench.h"
#include "peers/rows.h"
#include "peers/timing.h"
#include "support/bench_organs.h"

namespace resect::bench {

Findings memoryOfStillOrgan(const Effort& effort) {
  Findings findings;
  std::vector<double> sizes = {1e4, 1e5};
  if (!effort.quick) sizes.push_back(1e6);
  for (const double size : sizes) {
    Organ organ = makeOrgan(liverCells(size), {});
    organ.surface.updateLook(organ.field);  // normals count
    const double n = double(organ.particles);
    findings.figures.push_back(
        {"H", fmt::format("bytes per particle at {}, nodes s/2 apart", organ.particles),
         fmt::format("{:.1f}: field {:.1f}, surface {:.1f}, lattice {:.1f}",
                     double(heldBytes(organ)) / n, double(organ.field.bytes()) / n,
                     double(organ.surface.bytes()) / n,
                     double(heldBytes(organ) - organ.field.bytes() - organ.surface.bytes()) / n),
         size == 1e6 ? "at most 96" : ""});
  }
  return findings;
}

Findings millionParticlesInRealTime(const Effort& effort) {
  Scenario scenario = readScenario(findDataFile("cut", "scenarios", ".toml"));
  scenario.organs[0].source.spacing = spacingFor(effort.quick ? 1e5 : 1e6);
  Findings findings;
  std::vector<std::uint64_t> states;
  for (const int threads : threadCounts()) {
    const ThreadLimit limit(threads);
    Simulation simulation = makeSimulation(
        scenario, [](const auto& p, const std::string& parts) { return readModel(p, parts); });
    const BenchReport report = benchScenario(simulation, scenario);
    std::string text =
        fmt::format("median {:.2f} ms, p95 {:.2f}, max {:.2f}; {} of {} frames missed",
                    1e3 * report.frame.median, 1e3 * report.frame.p95, 1e3 * report.frame.max,
                    report.missed, report.frames);
    const std::string run = fmt::format("\"cut\", {} particles, {} thread{}", report.particles,
                                        threads, threads > 1 ? "s" : "");
    findings.figures.push_back(
        {"I", "frame of " + run, text, fmt::format("{:.1f} ms", 1e3 * report.frameDuration)});
    states.push_back(report.stateHash);
  }
  const bool same = std::ranges::count(states, states[0]) == std::ssize(states);
  findings.figures.push_back({"I", "states at the end, at these numbers of threads",
                              same ? "the same" : "different", "the same"});
  return findings;
}

}  // namespace resect::bench
