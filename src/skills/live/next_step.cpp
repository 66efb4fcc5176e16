#include "skills/live/next_step.h"

#include <fmt/format.h>

#include <algorithm>

namespace resect {
namespace {

using Kind = TaskGoal::Kind;

std::string nextTouch(const Attempt& attempt, const TaskGoal& goal, std::size_t target) {
  const auto& distances = attempt.goal.distance;
  const bool there = target < distances.size() && !distances[target].empty() &&
                     double(distances[target].back()) <= goal.radius;
  return there ? fmt::format("Hold the tip there for {:g} s.", goal.hold)
               : fmt::format("Touch target {} of {}.", target + 1, goal.places.size());
}

std::string nextFollow(const Attempt& attempt, const TaskGoal& goal, const GoalResult& result) {
  const double covered = valueOf(result.measures, "line_covered_pct").value_or(0);
  const bool held = !attempt.goal.held.empty() && attempt.goal.held.back();
  if (!goal.holdWith.empty() && !held)
    return fmt::format("Hold the tissue with the {}, and leave it holding.", goal.holdWith);
  if (covered >= 100 * kLineFollowed)
    return "The cut went too far from the line, which cannot be mended: finish, and begin again.";
  return covered > 0 ? fmt::format("Go on along the line: {:.0f} % done; missing: {}.", covered,
                                   result.missing)
                     : "Cut along the line, from one end to the other.";
}

std::string nextResect(const Attempt& attempt, const TaskGoal& goal) {
  if (attempt.tissue.back().cut <= 0)
    return fmt::format("Cut round the {}, at least {:g} mm away from it.", goal.structure,
                       1e3 * goal.margin);
  return fmt::format("Go on until the piece with the {} comes off.", goal.structure);
}

std::string nextStop(const Attempt& attempt, const TaskGoal& goal) {
  const std::vector<std::string>& steps = attempt.task->steps;
  const auto worst = worstBleeding(attempt);
  if (!worst) return steps.empty() ? "Nothing bleeds yet." : steps.front();
  if (const double most = bleedingRate(attempt, *worst); most < goal.from)
    return fmt::format("It does not bleed enough yet: {:.0f} of {:g} ml/min. {}", 60e6 * most,
                       60e6 * goal.from, steps.empty() ? "Cut deeper." : steps.front());
  const double rate = bleedingRate(attempt, attempt.bled.size() - 1);
  return rate < goal.rate
             ? fmt::format("Below {:g} ml/min: watch it for {:g} s.", 60e6 * goal.rate, goal.hold)
             : fmt::format("Stop the bleeding of {:.0f} ml/min.", 60e6 * rate);
}

std::string nextDivide(const Attempt& attempt) {
  if (attempt.clips.empty()) return "Place a clip on the vessel, on the side of the heart.";
  return attempt.clips.size() == 1 ? "Place the second clip, on the far side."
                                   : "Cut the vessel between the clips.";
}

std::string nextTransect(const Attempt& attempt) {
  return attempt.goal.work.empty() ? "Cut along the plane."
                                   : "Go on along the plane until the part comes off.";
}

double measured(const GoalResult& goal, std::string_view measure) {
  return valueOf(goal.measures, measure).value_or(0);
}

}  // namespace

std::size_t nextTarget(const GoalResult& goal) {
  return std::size_t(measured(goal, "targets_held"));
}

std::string nextStep(const Attempt& attempt, const GoalResult& goal) {
  const TaskGoal& wanted = attempt.task->goal;
  if (goal.reached) return "The goal is reached: let the instruments rest, and the exercise ends.";
  switch (wanted.kind) {
    case Kind::Touch:
      return nextTouch(attempt, wanted, nextTarget(goal));
    case Kind::Follow:
      return nextFollow(attempt, wanted, goal);
    case Kind::Resect:
      return nextResect(attempt, wanted);
    case Kind::StopBleeding:
      return nextStop(attempt, wanted);
    case Kind::Divide:
      return nextDivide(attempt);
    case Kind::Transect:
      return nextTransect(attempt);
  }
  return "";
}

}  // namespace resect
