#include "cli/run_report.h"

#include <fmt/format.h>

#include "base/text/shown_text.h"

namespace resect {
namespace {

nlohmann::ordered_json toJson(const SurfaceSummary& surface) {
  return {{"triangles", surface.triangles},
          {"closed", surface.closed},
          {"oriented", surface.oriented},
          {"volume_ml", 1e6 * surface.volume}};
}

nlohmann::ordered_json toJson(const LabelSummary::Amount& amount) {
  return {{"particles", amount.particles},
          {"tissue_ml", 1e6 * amount.volume},
          {"mass_g", 1e3 * amount.mass}};
}

// Whether there are labels besides the organ's own.
bool hasLabels(const RunSummary& summary) {
  return summary.labels.size() > 1 || (summary.labels.size() == 1 && summary.labels[0].label > 0);
}

}  // namespace

nlohmann::ordered_json toJson(const RunSummary& summary, const Scenario& scenario) {
  nlohmann::ordered_json json;
  json["scenario"] = scenario.name;
  json["particles"] = summary.particles;
  json["organ_ml"] = 1e6 * summary.organVolume;
  json["removed"] = summary.removed;
  json["removed_ml"] = 1e6 * summary.removedVolume;
  json["touched"] = summary.touched;
  json["remaining_ml"] = 1e6 * summary.remainingVolume;
  json["deepest_overlap_ml"] = 1e6 * summary.deepestOverlap;
  json["frames"] = summary.frames;
  json["surface_before"] = toJson(summary.surfaceBefore);
  json["surface"] = toJson(summary.surface);
  json["pieces"] = nlohmann::ordered_json::array();
  for (const PieceSummary& piece : summary.pieces) {
    json["pieces"].push_back(toJson(piece.surface));
    json["pieces"].back()["organ"] = piece.organ;
    json["pieces"].back()["particles"] = piece.particles;
    json["pieces"].back()["tissue_ml"] = 1e6 * piece.tissue;
    json["pieces"].back()["mass_g"] = 1e3 * piece.mass;
  }
  if (hasLabels(summary))
    for (const LabelSummary& label : summary.labels)
      json["labels"].push_back({{"organ", label.organ},
                                {"label", label.label},
                                {"name", label.name},
                                {"before", toJson(label.before)},
                                {"removed", toJson(label.removed)},
                                {"remaining", toJson(label.remaining)}});
  for (const StageTimes& stage : summary.stages) {
    const TimeSummary t = summarise(stage.seconds);
    json["stages_ms"][stage.name] = {{"median", 1e3 * t.median},
                                     {"p95", 1e3 * t.p95},
                                     {"max", 1e3 * t.max},
                                     {"total", 1e3 * t.total}};
  }
  json["simulated_s"] = summary.simulatedSeconds;
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
  row("organ",
      fmt::format("{} particles, {:.1f} ml", summary.particles, 1e6 * summary.organVolume));
  row("removed",
      fmt::format("{} particles, {:.1f} ml ({:.2f} %)", summary.removed,
                  1e6 * summary.removedVolume, 100 * summary.removedVolume / summary.organVolume));
  row("overlap", fmt::format("{:.2f} ml of tool and organ in one place at most",
                             1e6 * summary.deepestOverlap));
  row("surface",
      fmt::format("{} triangles round {:.1f} ml, {}, {}", summary.surface.triangles,
                  1e6 * summary.surface.volume, summary.surface.closed ? "closed" : "OPEN",
                  summary.surface.oriented ? "oriented" : "NOT ORIENTED"));
  std::string pieces;  // in millilitres of tissue, which add up with what was removed
  for (std::size_t i = 0; i < summary.pieces.size() && i < 4; ++i)
    pieces += fmt::format("{}{:.1f} ml ({:.1f} g)", i ? " + " : "", 1e6 * summary.pieces[i].tissue,
                          1e3 * summary.pieces[i].mass);
  if (summary.pieces.size() > 4) pieces += fmt::format(" + {} smaller", summary.pieces.size() - 4);
  row("pieces",
      fmt::format("{}: {}", summary.pieces.size(), pieces.empty() ? "nothing is left" : pieces));
  if (hasLabels(summary))
    for (const LabelSummary& label : summary.labels)
      row(&label == &summary.labels[0] ? "labels" : "",
          fmt::format("{}{}: {} of {} particles removed, {:.2f} of {:.2f} ml, {:.2f} of {:.2f} g",
                      label.organ == "organ" ? "" : shownText(label.organ) + ", ",
                      shownText(label.name), label.removed.particles, label.before.particles,
                      1e6 * label.removed.volume, 1e6 * label.before.volume,
                      1e3 * label.removed.mass, 1e3 * label.before.mass));
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
  if (!summary.touched)
    row("note",
        "no instrument met an organ: their ways lie in the room, where the scenario puts them");
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
