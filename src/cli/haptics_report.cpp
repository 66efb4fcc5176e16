#include "cli/haptics_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "base/text/shown_text.h"

namespace resect {

nlohmann::ordered_json toJson(const HapticsReport& r, const Scenario& scenario) {
  nlohmann::ordered_json json;
  json["scenario"] = scenario.name;
  json["seconds"] = r.seconds;
  json["cycles"] = r.cycles;
  json["missed_cycles"] = r.missed;
  json["met_percent"] = 100 * r.met();
  json["jitter_us"] = {{"p50", 1e6 * r.p50}, {"p99", 1e6 * r.p99}, {"max", 1e6 * r.latest}};
  json["real_time_priority"] = r.rights.priority;
  json["locked_memory"] = r.rights.lockedMemory;
  json["frames"] = r.frames;
  json["frame_duration_ms"] = 1e3 * r.frameDuration;
  json["late_frames"] = r.lateFrames;
  json["frame_ms"] = {
      {"median", 1e3 * r.frame.median}, {"p95", 1e3 * r.frame.p95}, {"max", 1e3 * r.frame.max}};
  json["hands"] = nlohmann::ordered_json::array();
  for (const HandReport& hand : r.hands) {
    nlohmann::ordered_json one;
    one["tool"] = hand.tool;
    one["noise_windows"] = hand.noise.windows;
    one["noise_percent"] =
        hand.noise.windows > 0 ? nlohmann::ordered_json(100 * hand.noise.typical) : nullptr;
    one["worst_noise_percent"] =
        hand.noise.windows > 0 ? nlohmann::ordered_json(100 * hand.noise.worst) : nullptr;
    one["peak_force_N"] = hand.peakForce;
    one["peak_stiffness_N_per_m"] = hand.peakStiffness;
    one["largest_step_N"] = hand.largestStep;
    one["correction_N"] = hand.correction;
    one["energy_to_hand_J"] = hand.energy;
    one["most_energy_to_hand_J"] = hand.mostEnergy;
    one["guarded_cycles"] = hand.guarded;
    json["hands"].push_back(one);
  }
  return json;
}

std::string toText(const HapticsReport& r, const Scenario& scenario) {
  std::string text = fmt::format("{}\n", shownText(scenario.title));
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", what, value);
  };
  row("loop", fmt::format("{} cycles of 1 ms, {:.3f} % in time, {} missed", r.cycles, 100 * r.met(),
                          r.missed));
  row("jitter", fmt::format("median {:.0f} us, 99 % within {:.0f} us, at most {:.0f} us",
                            1e6 * r.p50, 1e6 * r.p99, 1e6 * r.latest));
  row("system", fmt::format("{} priority, memory {}", r.rights.priority ? "real-time" : "ordinary",
                            r.rights.lockedMemory ? "locked" : "not locked"));
  row("frames",
      fmt::format("{} of {:.1f} ms; median {:.1f} ms, 95 % within {:.1f} ms; {} late", r.frames,
                  1e3 * r.frameDuration, 1e3 * r.frame.median, 1e3 * r.frame.p95, r.lateFrames));
  text += fmt::format("\n  {:<10}{:>9}{:>9}{:>9}{:>9}{:>10}{:>11}{:>11}{:>11}{:>9}\n", "hand",
                      "noise %", "worst %", "peak N", "step N", "unseen N", "peak N/m", "energy mJ",
                      "at most mJ", "guarded");
  for (const HandReport& hand : r.hands) {
    const auto noise = [&](double share) {
      return hand.noise.windows > 0 ? fmt::format("{:.3f}", 100 * share) : std::string("-");
    };
    text +=
        fmt::format("  {:<10}{:>9}{:>9}{:>9.2f}{:>9.3f}{:>10.3f}{:>11.0f}{:>11.2f}{:>11.4f}{:>9}\n",
                    shownText(hand.tool), noise(hand.noise.typical), noise(hand.noise.worst),
                    hand.peakForce, hand.largestStep, hand.correction, hand.peakStiffness,
                    1e3 * hand.energy, 1e3 * hand.mostEnergy, hand.guarded);
  }
  const auto untouched = [](const HandReport& hand) { return !(hand.peakForce > 0); };
  if (std::ranges::all_of(r.hands, untouched))
    text += fmt::format(
        "  in {:g} s no instrument has touched tissue: give more --seconds, or another scenario\n",
        r.seconds);
  return text;
}

}  // namespace resect
