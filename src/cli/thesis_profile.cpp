#include "cli/thesis_profile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "sph/field_stencil.h"

namespace resect {
namespace {

// A stage's work in the thesis's program, and its share of the time there.
struct Counterpart {
  const char *stage, *functions;
  double share120, share950;  // %, sums of the functions' own times; 0: not listed by itself
};
// idleCB() moves the tool's vertices, tests particles and takes those inside out.
constexpr Counterpart kCounterparts[] = {
    {"findContacts", "idleCB(), Object::getCoordinateLoaded(), Object::computeBoundingBox()",
     4.23 + 2.14 + 1.74, 0.10 + 0.06 + 0.07},
    {"actTools", "in idleCB()", 0, 0},
    {"applyEdits", "in idleCB()", 0, 0},
    {"updateField", "ParticleList::getLevelSet(), setData()", 86.07, 98.63 + 0.16},
    {"updateSurface", "MarchingCubes::calcPoints(), MarchingCubes::calcGradients()", 2.38,
     0.61 + 0.16},
};

// What was counted in the thesis's runs on its Pentium III of 500 MHz.
struct ThesisRun {
  int particles;
  double Counterpart::*share;
  std::int64_t inHand, updates, nodes;  // idleCB's calls of getTool(), of updateOrgan(); grid
  double updateMs;  // setData() with what it calls, calcPoints() and calcGradients(), a call
};
constexpr ThesisRun kThesisRuns[] = {
    {120, &Counterpart::share120, 4442, 25, 20 * 20 * 20, 1e3 * (0.01 + 5.80) / 26 + 5.72},
    {950, &Counterpart::share950, 1061, 69, 30 * 30 * 30, 3220.76 + 19.42 + 5.09},
};

const ThesisRun* runOfSize(std::int64_t particles) {
  const auto* run = std::ranges::find_if(kThesisRuns, [&](const ThesisRun& r) {
    return std::abs(double(particles) / r.particles - 1) <= 0.05;
  });
  return run == std::end(kThesisRuns) ? nullptr : run;
}

const Counterpart* counterpartOf(const std::string& stage) {
  const auto* found = std::ranges::find_if(
      kCounterparts, [&](const Counterpart& counterpart) { return stage == counterpart.stage; });
  return found == std::end(kCounterparts) ? nullptr : found;
}

std::vector<BenchReport::Stage> byTime(const BenchReport& report) {
  std::vector<BenchReport::Stage> stages = report.stages;
  std::ranges::stable_sort(stages, std::greater{}, [](const auto& s) { return s.time.total; });
  return stages;
}

double percent(double part, double whole) { return 100 * part / std::max(1e-12, whole); }

double anUpdate(double sum, const BenchReport::Updates& updates) {
  return sum / double(std::max<std::int64_t>(1, updates.frames));
}

double nodesAnUpdate(const BenchReport& report) {
  return anUpdate(double(report.updates.bricks * kBrickSize), report.updates);
}

double updateMs(const BenchReport& report) {
  return anUpdate(1e3 * report.updates.seconds, report.updates);
}

}  // namespace

nlohmann::ordered_json profileJson(const BenchReport& report) {
  nlohmann::ordered_json json;
  const ThesisRun* thesis = runOfSize(report.particles);
  for (const BenchReport::Stage& stage : byTime(report)) {
    nlohmann::ordered_json row = {{"stage", stage.name},
                                  {"calls", report.frames},
                                  {"total_ms", 1e3 * stage.time.total},
                                  {"share", percent(stage.time.total, report.frame.total)}};
    if (const Counterpart* there = counterpartOf(stage.name)) {
      row["thesis_functions"] = there->functions;
      if (thesis && there->*thesis->share > 0) row["thesis_share"] = there->*thesis->share;
    }
    json["stages"].push_back(std::move(row));
  }
  json["frames_in_hand"] = report.inHand;
  json["surface_updates"] = report.updates.frames;
  json["nodes_an_update"] = nodesAnUpdate(report);
  json["ms_an_update"] = updateMs(report);
  return json;
}

std::string profileText(const BenchReport& report) {
  const ThesisRun* thesis = runOfSize(report.particles);
  std::string text =
      fmt::format("\n  {:>6} {:>10} {:>7} {:>9}  {:<14} {:>6}  {}\n", "share", "total, ms", "calls",
                  "us a call", "stage", "thesis", "its functions");
  for (const BenchReport::Stage& stage : byTime(report)) {
    const Counterpart* there = counterpartOf(stage.name);
    const bool listed = thesis && there && there->*thesis->share > 0;
    text += fmt::format("  {:>5.1f}% {:>10.3f} {:>7} {:>9.3f}  {:<14} {:>6}  {}\n",
                        percent(stage.time.total, report.frame.total), 1e3 * stage.time.total,
                        report.frames,
                        1e6 * stage.time.total / double(std::max<std::int64_t>(1, report.frames)),
                        stage.name, listed ? fmt::format("{:.1f}%", there->*thesis->share) : "-",
                        there ? there->functions : "-");
  }
  text += fmt::format("  {:>5.1f}% {:>10.3f}\n\n  {:<34}{:>10}{:>10}\n", 100.0,
                      1e3 * report.frame.total, "", "here", thesis ? "thesis" : "");
  const auto row = [&](const char* what, const std::string& here, const std::string& there) {
    text += fmt::format("  {:<34}{:>10}{:>10}\n", what, here, thesis ? there : "");
  };
  const ThesisRun& there = thesis ? *thesis : kThesisRuns[0];
  const auto number = [](auto value) { return fmt::format("{}", value); };
  row("particles", number(report.particles), number(there.particles));
  row("frames with an instrument in hand", number(report.inHand), number(there.inHand));
  row("surface updates", number(report.updates.frames), number(there.updates));
  row("nodes of the field, an update", fmt::format("{:.0f}", nodesAnUpdate(report)),
      number(there.nodes));
  row("ms, an update", fmt::format("{:.3f}", updateMs(report)),
      fmt::format("{:.0f}", there.updateMs));
  return text;
}

}  // namespace resect
