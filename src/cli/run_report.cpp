#include "cli/run_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "base/text/printed_time.h"
#include "base/text/shown_text.h"
#include "cli/blood_report.h"
#include "cli/ledger_report.h"
#include "operation/blood/dangers.h"
#include "operation/promises.h"
#include "operation/way/place_ways.h"

namespace resect {
namespace {

nlohmann::ordered_json toJson(const SurfaceSummary& surface) {
  return {{"triangles", surface.triangles},
          {"closed", surface.closed},
          {"oriented", surface.oriented},
          {"volume_ml", 1e6 * surface.volume}};
}

// To the millimetre, and never -0.
std::string coordinate(double metres) {
  return fmt::format("{:.3f}", (std::round(1e3 * metres) + 0.0) / 1e3);
}

}  // namespace

nlohmann::ordered_json toJson(const RunSummary& summary, const Scenario& scenario) {
  nlohmann::ordered_json json;
  json["scenario"] = scenario.name;
  const TissueSplit tissue = summary.ledger.tissue();
  json["particles"] = tissue.before.particles;
  json["organ_ml"] = 1e6 * tissue.before.volume;
  json["removed"] = tissue.removed.particles;
  json["removed_ml"] = 1e6 * tissue.removed.volume;
  json["remaining_ml"] = 1e6 * tissue.left().volume;  // body, pieces and debris
  json["touched"] = summary.touched;
  json["findings"] = findings(summary, scenario);
  json["dangers"] = summary.blood ? dangersOf(*summary.blood) : std::vector<std::string>{};
  json["ledger"] = toJson(summary.ledger);
  json["deepest_overlap_ml"] = 1e6 * summary.deepestOverlap;
  json["frames"] = summary.frames;
  json["surface_before"] = toJson(summary.surfaceBefore);
  json["surface"] = toJson(summary.surface);
  for (const StageTimes& stage : summary.stages) {
    const TimeSummary t = summarise(stage.seconds);
    json["stages_ms"][stage.name] = {{"median", 1e3 * t.median},
                                     {"p95", 1e3 * t.p95},
                                     {"max", 1e3 * t.max},
                                     {"total", 1e3 * t.total}};
  }
  json["simulated_s"] = printedTime(summary.simulatedSeconds);
  json["real_time_factor"] = summary.realTimeFactor();
  if (summary.tissueMoves) {
    json["tissue"] = {{"severed_bonds", summary.severed},
                      {"torn_bonds", summary.torn},
                      {"substeps", summary.substeps},
                      {"retries", summary.retries}};
    json["tool_forces_n"] = nlohmann::ordered_json::array();
    for (const ToolForces& forces : summary.forces)
      json["tool_forces_n"].push_back(
          {{"tool", forces.tool}, {"peak", forces.peak}, {"per_frame", forces.perFrame}});
  }
  if (summary.blood) json["blood"] = toJson(*summary.blood);
  if (!summary.segments.empty()) json["segments"] = toJson(summary.segments);
  json["faults"] = summary.faults;
  json["state_hash"] = fmt::format("{:016x}", summary.stateHash);
  return json;
}

std::string toText(const RunSummary& summary, const Scenario& scenario,
                   const std::vector<std::string>& files) {
  std::string text = fmt::format("{}\n", shownText(scenario.title));
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", what, value);
  };
  text += toText(summary.ledger);
  text += toText(summary.segments);
  if (summary.blood) text += toText(*summary.blood);
  if (summary.deepestOverlap > 0)  // moving tissue gives way instead
    row("overlap", fmt::format("{:.2f} ml of tool and organ in one place at most",
                               1e6 * summary.deepestOverlap));
  row("surface",
      fmt::format("{} triangles that bound {:.2f} ml, {}, {}", summary.surface.triangles,
                  1e6 * summary.surface.volume, summary.surface.closed ? "closed" : "OPEN",
                  summary.surface.oriented ? "oriented" : "NOT ORIENTED"));
  if (summary.tissueMoves) {
    std::string forces;
    for (const ToolForces& tool : summary.forces)
      if (tool.peak > 0)
        forces += fmt::format("{}{} {:.2f} N", forces.empty() ? "" : ", ", shownText(tool.tool),
                              tool.peak);
    row("tissue", fmt::format("{} bonds cut, {} torn; {:.1f} substeps per frame{}", summary.severed,
                              summary.torn, double(summary.substeps) / double(summary.frames),
                              summary.retries ? fmt::format(", {} retries", summary.retries) : ""));
    if (!forces.empty()) row("forces", "at most " + forces);
  }
  const bool anyMoves = std::ranges::any_of(
      scenario.tools, [](const ScenarioTool& tool) { return !tool.keys.empty(); });
  if (!summary.touched && anyMoves) {
    const Aabb& box = summary.surfaceBefore.box;
    const std::string why =
        hasWays(scenario) ? "cells may be too large for it, or the ways on it too short"
                          : "their ways lie in the room, where the scenario puts them; move the "
                            "organ or the ways";
    row("note",
        fmt::format("no instrument met an organ: {} {} to {} m from left to right, {} to {} m in "
                    "height and {} to {} m towards the surgeon; {}",
                    summary.ledger.organs.size() > 1 ? "the organs fill" : "the organ fills",
                    coordinate(box.min.x()), coordinate(box.max.x()), coordinate(box.min.y()),
                    coordinate(box.max.y()), coordinate(box.min.z()), coordinate(box.max.z()),
                    why));
  }
  for (const std::string& finding : findings(summary, scenario)) row("note", finding);
  if (summary.blood)
    for (const std::string& danger : dangersOf(*summary.blood)) row("danger", danger);
  row("time",
      fmt::format("{} frames = {:.2f} s simulated in {:.3f} s: {:.1f} x real time", summary.frames,
                  summary.simulatedSeconds, summary.computedSeconds, summary.realTimeFactor()));
  row("state", fmt::format("{:016x}", summary.stateHash));
  text += fmt::format("\n  {:<14}{:>10}{:>10}{:>10}{:>11}{:>8}\n", "stage, ms", "median", "p95",
                      "max", "total", "share");
  for (const StageTimes& stage : summary.stages) {
    const TimeSummary t = summarise(stage.seconds);
    text += fmt::format("  {:<14}{:>10.3f}{:>10.3f}{:>10.3f}{:>11.2f}{:>7.1f}%\n", stage.name,
                        1e3 * t.median, 1e3 * t.p95, 1e3 * t.max, 1e3 * t.total,
                        100 * t.total / std::max(1e-12, summary.computedSeconds));
  }
  for (const std::string& fault : summary.faults) text += "\n  fault: " + shownSentence(fault);
  if (!files.empty()) {
    text += "\n  written:\n";
    for (const std::string& file : files)
      text += "    " + shownText(file, kLongestShownPath) + "\n";
  }
  return text;
}

LinePlot forcePlot(const RunSummary& summary, const Scenario& scenario) {
  LinePlot plot{scenario.title, "time, s", "force on the instrument, N", {}};
  for (const ToolForces& tool : summary.forces) {
    if (!(tool.peak > 0)) continue;
    plot.lines.push_back({tool.tool, {}});
    for (std::size_t frame = 0; frame < tool.perFrame.size(); ++frame)
      plot.lines.back().points.push_back(
          {double(frame + 1) / scenario.frameRate, double(tool.perFrame[frame])});
  }
  return plot;
}

}  // namespace resect
