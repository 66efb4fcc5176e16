#include "operation/bench.h"

#include <algorithm>
#include <cmath>

#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect {
namespace {

// The next size is chosen so that the 95th percentile should be this fraction of a frame.
constexpr double kAim = 0.9;
constexpr double kCloseEnough = 1.15;  // ratio of the sizes that fail and hold
// Assumed exponent of a frame's time in the number of particles: for still tissue an instrument
// touches a share of the surface; moving tissue needs more, shorter substeps.
constexpr double kStillPower = 2.0 / 3, kElasticPower = 4.0 / 3;

// m, rounded to 0.01 mm or to three digits, whichever is finer.
double rounded(double spacing) {
  const double step = std::min(1e-5, std::pow(10, std::floor(std::log10(spacing)) - 2));
  return std::round(spacing / step) * step;
}

}  // namespace

BenchReport benchScenario(Simulation& simulation, const Scenario& scenario,
                          const FrameObserver& observer) {
  BenchReport report;
  report.spacing = std::cbrt(simulation.organ().rest.lattice.cellVolume());
  std::vector<double> particles;  // by organ, as the operation begins
  for (const OperatedOrgan& o : simulation.organs()) {
    particles.push_back(double(o.organ.particles));
    report.particles += o.organ.particles;
    report.triangles += o.organ.surface.triangleCount();
  }
  report.bytes = std::int64_t(simulation.bytes());
  report.tissueMoves = simulation.moves();
  report.frameDuration = 1 / scenario.frameRate;
  report.instructionSet = fastestKernel().name;

  StageClock clock;
  StepReport step;
  double moved = 0;                  // particles times substeps
  std::vector<std::size_t> updates;  // frames
  const std::int64_t frames = frameCount(scenario);
  while (report.frames < frames) {
    const FrameInput input = frameInput(scenario, report.frames);
    simulation.step(input, step, &clock);
    report.inHand += std::ranges::any_of(simulation.tools(), &ToolState::inHand);
    if (step.touchedBricks > 0) updates.push_back(std::size_t(report.frames));
    report.updates.bricks += step.touchedBricks;
    ++report.frames;
    for (std::size_t o = 0; o < step.tissue.size(); ++o) {
      report.substeps += step.tissue[o].substeps;
      moved += particles[o] * step.tissue[o].substeps;
    }
    if (observer && !observer(simulation, input, step)) break;
  }

  std::vector<double> wholeFrames(std::size_t(report.frames), 0.0);
  for (const StageTimes& stage : clock.stages()) {
    report.stages.push_back({stage.name, summarise(stage.seconds)});
    if (stage.name == "updateField" || stage.name == "updateSurface")
      for (const std::size_t frame : updates) report.updates.seconds += stage.seconds[frame];
    for (std::size_t i = 0; i < stage.seconds.size(); ++i) wholeFrames[i] += stage.seconds[i];
    if (stage.name == "moveTissue" && moved > 0)
      report.perParticleAndSubstep = report.stages.back().time.total / moved;
  }
  report.updates.frames = std::int64_t(updates.size());
  report.missed =
      std::ranges::count_if(wholeFrames, [&](double s) { return s > report.frameDuration; });
  report.frame = summarise(std::move(wholeFrames));
  report.stateHash = simulation.stateHash();
  return report;
}

RealTimeLimit findRealTimeLimit(const BenchReport& first,
                                const std::function<BenchReport(double spacing)>& measure,
                                int trials, double mostParticles) {
  RealTimeLimit limit;
  const auto keep = [&](const BenchReport& r) {
    auto& place = r.realTime() ? limit.holds : limit.fails;
    if (!place || (r.particles > place->particles) == r.realTime()) place = r;
  };
  keep(first);
  BenchReport last = first;
  const double power = first.tissueMoves ? kElasticPower : kStillPower;
  for (int trial = 0; trial < trials; ++trial) {
    double wanted = double(last.particles) *
                    std::pow(kAim * last.frameDuration / std::max(1e-9, last.frame.p95), 1 / power);
    wanted = std::clamp(wanted, 100.0, mostParticles);
    if (limit.holds && limit.fails) {
      const double low = double(limit.holds->particles), high = double(limit.fails->particles);
      if (high <= kCloseEnough * low) break;
      if (!(wanted > 1.02 * low && wanted < high / 1.02)) wanted = std::sqrt(low * high);
    } else if (limit.holds) {
      wanted = std::min(std::max(wanted, 1.3 * double(limit.holds->particles)), mostParticles);
    } else {
      wanted = std::min(wanted, 0.8 * double(limit.fails->particles));
    }
    const double spacing = rounded(first.spacing * std::cbrt(double(first.particles) / wanted));
    if (std::abs(wanted / double(last.particles) - 1) < 0.02 || spacing == last.spacing) break;
    last = measure(spacing);
    keep(last);
  }
  return limit;
}

}  // namespace resect
