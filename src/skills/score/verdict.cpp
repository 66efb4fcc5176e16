#include "skills/score/verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "operation/task/measure.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

bool keeps(const Check& check) {
  return check.value && (!check.least || check.value >= *check.least) &&
         (!check.most || check.value <= *check.most);
}

bool isAsked(const Task& task, const std::string& measure) {
  return std::ranges::count(task.pass, "all") > 0 || std::ranges::count(task.pass, measure) > 0;
}

std::vector<Check> checksOf(const Task& task, TaskLevel level, std::span<const Measured> measures) {
  std::vector<Check> checks;
  const auto add = [&](const std::string& measure, std::optional<double> least,
                       std::optional<double> most, std::string source) {
    const auto value = valueOf(measures, measure);
    const bool open = measure == "seal_time_s" && valueOf(measures, "vessels_open").value_or(0) > 0;
    // What else cannot be measured, as a margin where nothing was cut, is a matter of the goal.
    if (!value && !open) return;
    Check check{measure, value, least, most, true, isAsked(task, measure), std::move(source)};
    check.kept = keeps(check);
    checks.push_back(std::move(check));
  };
  for (const TaskLimit& limit : limitsAt(task, level))
    add(limit.measure, limit.least, limit.most,
        fmt::format("limit of the task, {}", wordOf(level)));
  for (const TaskBand& band : task.bands) {
    const auto better = findMeasure(band.measure)->better;
    const double width = task.bandWidth * band.deviation;
    std::optional<double> least, most;
    if (better != MeasureKind::Better::Less) least = band.mean - width;
    if (better != MeasureKind::Better::More) most = band.mean + width;
    add(band.measure, least, most,
        fmt::format("band of the task: {:.3g} +- {:.3g} in {} runs, {:g} deviations allowed",
                    band.mean, band.deviation, task.bandRuns, task.bandWidth));
  }
  return checks;
}

// Rules that no measure has: instruments, and work that was taken back.
std::vector<Deduction> brokenRules(const Attempt& attempt) {
  std::vector<Deduction> broken;
  const Task& task = *attempt.task;
  for (const InstrumentRecord& one : attempt.instruments) {
    if (task.instruments.empty() || std::ranges::count(task.instruments, one.model) > 0) continue;
    const auto first = std::ranges::find_if(one.moments, &ToolMoment::inHand);
    if (first == one.moments.end()) continue;
    broken.push_back({"", attempt.time[std::size_t(first - one.moments.begin())],
                      fmt::format("The {} was taken, which this task does not allow.", one.name),
                      "What was it to do that the allowed instruments could not?",
                      "Do the step with the instruments of the task."});
  }
  if (!task.undo && attempt.undos > 0)
    broken.push_back({"undos",
                      {},
                      fmt::format("Work was taken back {} times, which this task "
                                  "forbids.",
                                  attempt.undos),
                      "What would have been done next with a real patient?",
                      "Go on from a slip instead of taking it back."});
  return broken;
}

// Of checks; 1 if there are none.
double keptShare(const std::vector<Check>& checks) {
  if (checks.empty()) return 1;
  return double(std::ranges::count(checks, true, &Check::kept)) / double(checks.size());
}

std::string reasonOf(const Verdict& verdict, std::size_t rules) {
  std::string failed;
  for (const Check& check : verdict.checks)
    if (check.counts && !check.kept && !ranOut(check, verdict.goal))
      failed.append(failed.empty() ? "" : ", ").append(findMeasure(check.measure)->title);
  if (rules > 0) return verdict.deductions[0].fact;
  const auto clock = std::ranges::find_if(
      verdict.checks, [&](const Check& check) { return ranOut(check, verdict.goal); });
  const std::string over =
      clock == verdict.checks.end() ? "" : fmt::format(" The time of {:g} s was up.", *clock->most);
  if (!verdict.goal.reached)
    return verdict.goal.sentence + over +
           (failed.empty() ? "" : fmt::format(" Besides, not as wanted: {}.", failed));
  if (!failed.empty()) return fmt::format("The goal was reached, but not as wanted: {}.", failed);
  return verdict.goal.sentence;
}

}  // namespace

Scored score(Attempt attempt, std::optional<TaskLevel> level, bool graded) {
  Scored scored;
  require(attempt.task.has_value(), "{}: has no task to be scored by; give one", attempt.file);
  scored.level = attempt.task->level = level.value_or(attempt.task->level);
  Verdict& verdict = scored.verdict;
  verdict.graded = graded;
  verdict.goal = goalResult(attempt);
  scored.measures = measuresOf(attempt);
  scored.measures.insert(scored.measures.end(), verdict.goal.measures.begin(),
                         verdict.goal.measures.end());
  verdict.checks = checksOf(*attempt.task, scored.level, scored.measures);
  verdict.deductions = brokenRules(attempt);
  const std::size_t rules = verdict.deductions.size();
  const std::vector<Deduction> found = findings(attempt, verdict.goal, verdict.checks);
  verdict.deductions.insert(verdict.deductions.end(), found.begin(), found.end());
  verdict.good = praise(attempt, verdict.goal, verdict.checks);
  verdict.passed =
      rules == 0 && verdict.goal.reached &&
      std::ranges::all_of(verdict.checks, [&](const Check& c) { return !c.counts || c.kept; });
  verdict.score = 0.5 * verdict.goal.done;
  if (verdict.goal.reached && rules == 0) verdict.score += 0.5 * keptShare(verdict.checks);
  verdict.reason = reasonOf(verdict, rules);
  scored.attempt = std::move(attempt);
  return scored;
}

}  // namespace resect
