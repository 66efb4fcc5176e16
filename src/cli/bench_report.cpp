#include "cli/bench_report.h"

#include "base/text/shown_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace resect {
namespace {

nlohmann::ordered_json milliseconds(const TimeSummary& t) {
  return {{"median", 1e3 * t.median},
          {"p95", 1e3 * t.p95},
          {"max", 1e3 * t.max},
          {"total", 1e3 * t.total}};
}

nlohmann::ordered_json sizeJson(const BenchReport& r) {
  return {
      {"particles", r.particles}, {"spacing_mm", 1e3 * r.spacing}, {"p95_ms", 1e3 * r.frame.p95}};
}

std::string millimetres(double metres) { return fmt::format("{:.4g}mm", 1e3 * metres); }

// A sentence with the result and the setting to change.
std::string verdict(const BenchReport& report, const RealTimeLimit& limit) {
  const double frame = 1e3 * report.frameDuration;
  if (!limit.holds)
    return fmt::format(
        "no size tried keeps real time here: the smallest, {} particles, needs {:.1f} of {:.1f} "
        "ms; "
        "lower frame_rate in the scenario",
        limit.fails->particles, 1e3 * limit.fails->frame.p95, frame);
  const BenchReport& holds = *limit.holds;
  std::string text =
      fmt::format("{} particles keep real time here (95 % of frames within {:.1f} of {:.1f} ms)",
                  holds.particles, 1e3 * holds.frame.p95, frame);
  text += limit.fails ? fmt::format("; {} do not ({:.1f} ms)", limit.fails->particles,
                                    1e3 * limit.fails->frame.p95)
                      : std::string("; no larger organ was tried");
  if (holds.spacing != report.spacing)
    text += fmt::format("; give --spacing {0}, or spacing = \"{0}\" under [organ]",
                        millimetres(holds.spacing));
  return text;
}

}  // namespace

nlohmann::ordered_json toJson(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                              const Scenario& scenario) {
  nlohmann::ordered_json json;
  json["scenario"] = scenario.name;
  json["particles"] = report.particles;
  json["spacing_mm"] = 1e3 * report.spacing;
  json["triangles"] = report.triangles;
  json["bytes"] = report.bytes;
  json["bytes_per_particle"] = report.bytesPerParticle();
  json["frames"] = report.frames;
  json["frame_duration_ms"] = 1e3 * report.frameDuration;
  json["missed_frames"] = report.missed;
  json["frame_ms"] = milliseconds(report.frame);
  for (const BenchReport::Stage& stage : report.stages)
    json["stages_ms"][stage.name] = milliseconds(stage.time);
  if (report.tissueMoves) {
    json["substeps"] = report.substeps;
    json["ns_per_particle_and_substep"] = 1e9 * report.perParticleAndSubstep;
  }
  json["instruction_set"] = report.instructionSet;
  json["state_hash"] = fmt::format("{:016x}", report.stateHash);
  json["real_time"] = report.realTime();
  if (limit) {
    json["largest_in_real_time"] = limit->holds ? sizeJson(*limit->holds) : nullptr;
    json["smallest_too_slow"] = limit->fails ? sizeJson(*limit->fails) : nullptr;
    json["verdict"] = verdict(report, *limit);
  }
  return json;
}

std::string toText(const BenchReport& report, const std::optional<RealTimeLimit>& limit,
                   const Scenario& scenario) {
  std::string text = fmt::format("{}\n", shownText(scenario.title));
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", what, value);
  };
  row("organ", fmt::format("{} particles {} apart, {} triangles", report.particles,
                           millimetres(report.spacing), report.triangles));
  row("memory", fmt::format("{:.1f} MB, {:.0f} bytes per particle", 1e-6 * double(report.bytes),
                            report.bytesPerParticle()));
  if (report.tissueMoves)
    row("tissue", fmt::format("{:.1f} substeps per frame, {:.1f} ns per particle and substep",
                              double(report.substeps) / double(report.frames),
                              1e9 * report.perParticleAndSubstep));
  row("frames", fmt::format("{} of {:.1f} ms, {} missed", report.frames, 1e3 * report.frameDuration,
                            report.missed));
  row("state", fmt::format("{:016x}", report.stateHash));
  row("vectors", report.instructionSet);
  text += fmt::format("\n  {:<14}{:>10}{:>10}{:>10}{:>11}{:>8}\n", "stage, ms", "median", "p95",
                      "max", "total", "share");
  const auto times = [&](const std::string& name, const TimeSummary& t) {
    text += fmt::format("  {:<14}{:>10.3f}{:>10.3f}{:>10.3f}{:>11.2f}{:>7.1f}%\n", name,
                        1e3 * t.median, 1e3 * t.p95, 1e3 * t.max, 1e3 * t.total,
                        100 * t.total / std::max(1e-12, report.frame.total));
  };
  for (const BenchReport::Stage& stage : report.stages) times(stage.name, stage.time);
  times("whole frame", report.frame);
  if (limit) text += fmt::format("\n  {}\n", verdict(report, *limit));
  return text;
}

}  // namespace resect
