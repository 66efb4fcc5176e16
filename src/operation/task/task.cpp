#include "operation/task/task.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"

namespace resect {

std::string_view wordOf(TaskGoal::Kind kind) {
  switch (kind) {
    case TaskGoal::Kind::Touch:
      return "touch";
    case TaskGoal::Kind::Follow:
      return "follow";
    case TaskGoal::Kind::Resect:
      return "resect";
    case TaskGoal::Kind::StopBleeding:
      return "stop-bleeding";
    case TaskGoal::Kind::Divide:
      return "divide";
    case TaskGoal::Kind::Transect:
      return "transect";
  }
  throw usageError("there is no goal {}; use one of TaskGoal::Kind", int(kind));
}

std::string_view wordOf(TaskLevel level) {
  return level == TaskLevel::Easy ? "easy" : level == TaskLevel::Medium ? "medium" : "hard";
}

std::optional<TaskLevel> taskLevel(std::string_view word) {
  const auto at = std::ranges::find_if(kTaskLevels, [&](TaskLevel l) { return wordOf(l) == word; });
  if (at == kTaskLevels.end()) return {};
  return *at;
}

std::vector<TaskLimit> limitsAt(const Task& task, TaskLevel level) {
  std::vector<TaskLimit> limits = task.limits;
  for (const TaskLimit& own : task.levels[std::size_t(level)]) {
    const auto at = std::ranges::find(limits, own.measure, &TaskLimit::measure);
    if (at == limits.end())
      limits.push_back(own);
    else
      *at = own;
  }
  return limits;
}

std::optional<double> mostOf(const Task& task, std::string_view measure) {
  for (const TaskLimit& limit : limitsAt(task, task.level))
    if (limit.measure == measure) return limit.most;
  return {};
}

std::optional<ForceLimit> forceLimitOf(const Task& task) {
  const auto peak = mostOf(task, "force_peak_n");
  if (peak && peak != task.forceLimit)
    return ForceLimit{*peak, fmt::format("limit of the task, {}", wordOf(task.level))};
  if (task.forceLimit) return ForceLimit{*task.forceLimit, task.forceLimitSource};
  return {};
}

}  // namespace resect
