#include "haptics/bench/haptics_bench.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/stop.h"

namespace resect {
namespace {

constexpr double kSettles = 0.1;  // s for which a hand holds still before its noise counts
// After its last key a hand rests, then goes back to the first one; s.
constexpr double kRests = 0.1, kGoesBack = 0.3;

struct Held {
  std::size_t tool;  // its number in the scenario
  Vec3 origin;       // of the device's workspace, world, m
};

std::vector<Held> toolsInHand(const Simulation& simulation, const Scenario& scenario,
                              const std::string& wanted, bool plays) {
  std::vector<Held> held;
  for (std::size_t i = 0; i < scenario.tools.size(); ++i) {
    const ScenarioTool& tool = scenario.tools[i];
    const ToolModel& model = simulation.tools()[i].tool->model;
    if (tool.keys.empty() || (!wanted.empty() && wanted != tool.model && wanted != model.name))
      continue;
    held.push_back({i, plays ? Vec3(Vec3::Zero()) : tool.keys.front().pose.position});
  }
  require(!held.empty(), "the scenario moves no instrument{}; give one that it moves",
          wanted.empty() ? "" : " \"" + wanted + "\"");
  return held;
}

bool same(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() < 1e-9 &&
         (a.rotation.coeffs() - b.rotation.coeffs()).norm() < 1e-9;
}

// Where the scenario wants the tool; while it is not in hand, where it is taken next.
HandIntent intentOf(const ScenarioTool& tool, double time, double duration) {
  const double first = tool.keys.front().time, last = tool.keys.back().time;
  const auto at = [&](double t) { return toolInputAt(tool, std::clamp(t, first, last)).pose; };
  if (time > last) {
    const double takes = std::clamp(duration - last - kRests, 1e-3, kGoesBack);
    const double share = std::clamp((time - last - kRests) / takes, 0.0, 1.0);
    return {interpolate(at(last), at(first), share), false};
  }
  const Pose now = at(time);
  return {now, time - kSettles > first && same(now, at(time - kSettles))};
}

double largestStiffness(const LocalModel& model) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(model.stiffness, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return double(*at);
}

void summarise(std::span<const HapticSample> samples, HandReport& hand) {
  hand.noise = forceNoise(samples);
  double squares = 0;
  std::int64_t models = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    hand.peakForce = std::max(hand.peakForce, double(samples[i].force.norm()));
    if (i > 0)
      hand.largestStep =
          std::max(hand.largestStep, double((samples[i].force - samples[i - 1].force).norm()));
    if (samples[i].correction > 0)
      squares += double(samples[i].correction) * double(samples[i].correction), ++models;
  }
  if (models > 0) hand.correction = std::sqrt(squares / double(models));
}

}  // namespace

HapticsReport benchHaptics(Simulation& simulation, const Scenario& scenario,
                           const HapticPlugin& plugin, const HapticsSetup& setup,
                           const std::function<void(double)>& progress) {
  require(setup.seconds >= 1 && setup.seconds <= 3600, "the run is to last {} s; give 1 to 3600 s",
          setup.seconds);
  const bool plays = plugin.functions().intend != nullptr;
  const std::vector<Held> held = toolsInHand(simulation, scenario, setup.tool, plays);
  std::vector<std::unique_ptr<HapticDevice>> devices;
  for (std::size_t k = 0; k < held.size(); ++k)
    devices.push_back(std::make_unique<HapticDevice>(plugin, setup.options));

  HapticsReport report;
  report.frameDuration = 1 / scenario.frameRate;
  for (const Held& one : held)
    report.hands.emplace_back().tool = simulation.tools()[one.tool].tool->model.name;
  const Bytes beginning = simulation.save();
  LocalModels models;
  StepReport step;
  std::vector<double> frames;
  frames.reserve(std::size_t(setup.seconds * scenario.frameRate) + 1);
  FrameInput input = frameInput(scenario, 0);
  double round = 0;

  HapticLoop loop(std::move(devices), setup.seconds, [&](std::size_t hand, double time) {
    return intentOf(scenario.tools[held[hand].tool], std::fmod(time, scenario.duration),
                    scenario.duration);
  });
  for (std::int64_t due = 0;; ++due) {
    const double now = loop.time();
    if (now >= setup.seconds) break;
    loop.check();
    checkStop();
    if (const double rounds = std::floor(now / scenario.duration); rounds > round) {
      round = rounds;
      simulation.restore(beginning);
    }
    const double began = steadySeconds(), time = std::fmod(now, scenario.duration);
    for (std::size_t i = 0; i < input.tools.size(); ++i)
      input.tools[i] = toolInputAt(scenario.tools[i], time);
    for (std::size_t k = 0; k < held.size(); ++k)
      if (ToolInput& tool = input.tools[held[k].tool]; tool.inHand) {
        tool.pose = loop.pose(k);
        tool.pose.position += held[k].origin;
      }
    simulation.step(input, step);
    for (std::size_t k = 0; k < held.size(); ++k) {
      LocalModel model = models.make(simulation, held[k].tool, input.duration);
      report.hands[k].peakStiffness =
          std::max(report.hands[k].peakStiffness, largestStiffness(model));
      model.pose.position -= held[k].origin;
      model.restPlace -= held[k].origin;
      for (ContactPlane& plane : model.planes) plane.place -= held[k].origin;
      loop.give(k, model);
    }
    frames.push_back(steadySeconds() - began);
    if (progress) progress(std::min(1.0, now / setup.seconds));
    // A frame that comes late is not made up for: tissue then moves in slow motion.
    const double next = double(due + 1) * report.frameDuration;
    if (const double late = loop.time() - next; late > report.frameDuration)
      due += std::int64_t(late / report.frameDuration);
    else
      sleepUntil(steadySeconds() - late);
  }
  report.seconds = loop.time();
  loop.stop();

  const HapticTimes& times = loop.times();
  report.cycles = times.cycles;
  report.missed = times.missed;
  report.rights = times.rights;
  report.p50 = quantile(times.lateness, 0.5);
  report.p99 = quantile(times.lateness, 0.99);
  report.latest = quantile(times.lateness, 1);
  report.frames = std::int64_t(frames.size());
  report.lateFrames =
      std::ranges::count_if(frames, [&](double s) { return s > report.frameDuration; });
  report.frame = resect::summarise(std::move(frames));
  for (std::size_t k = 0; k < held.size(); ++k) {
    HandReport& hand = report.hands[k];
    summarise(loop.samples(k), hand);
    hand.energy = loop.guard(k).energyToHand();
    hand.mostEnergy = loop.guard(k).mostEnergyToHand();
    hand.guarded = loop.guard(k).interventions();
  }
  return report;
}

}  // namespace resect
