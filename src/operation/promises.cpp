#include "operation/promises.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/shown_text.h"

namespace resect {
namespace {

constexpr double kLeastPush = 0.01;  // N
constexpr int kDryGrade = 1;         // VIBe: at most 5 ml/min

bool kept(std::string_view word, const RunSummary& summary) {
  const bool removed = summary.ledger.tissue().removed.particles > 0;
  if (word == "removal") return removed;
  if (word == "cut") return !removed && summary.severed > 0;
  if (word == "push")
    return !removed && summary.severed == 0 &&
           std::ranges::any_of(summary.forces,
                               [](const ToolForces& tool) { return tool.peak > kLeastPush; });
  if (word == "parts") return summary.ledger.pieces() > 0;
  if (word == "dry") return !summary.blood || bleedingGrade(summary.blood->rate) <= kDryGrade;
  return summary.blood && summary.blood->ledger.bled > 0;
}

}  // namespace

std::vector<std::string> findings(const RunSummary& summary, const Scenario& scenario) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < scenario.tools.size() && i < summary.toolTouched.size(); ++i) {
    const ScenarioTool& tool = scenario.tools[i];
    if (tool.keys.empty() || summary.toolTouched[i]) continue;
    const double first = tool.keys.front().time;
    sentences.push_back(
        first < summary.simulatedSeconds
            ? fmt::format("{} was in hand and met no organ", shownText(tool.model))
            : fmt::format("{} was never in hand: its first key is at {:.1f} s, and the run ends at "
                          "{:.1f} s",
                          shownText(tool.model), first, summary.simulatedSeconds));
  }
  for (const std::string& word : scenario.promises) {
    const auto kind = std::ranges::find(kPromises, word, &PromiseKind::word);
    if (kind != kPromises.end() && !kept(word, summary))
      sentences.push_back(fmt::format("not as the scenario is meant: {}", kind->sentence));
  }
  return sentences;
}

}  // namespace resect
