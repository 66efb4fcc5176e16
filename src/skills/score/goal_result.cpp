#include "skills/score/goal_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "blood/bleeding.h"
#include "skills/score/line_goal.h"

namespace resect {
namespace {

using Kind = TaskGoal::Kind;

// How the target that comes after those that were held was missed, from frame `from` on.
struct Missed {
  std::string sentence;
  double time = 0;  // s
};

Missed missedTarget(const Attempt& attempt, const TaskGoal& goal, std::size_t target,
                    std::size_t from) {
  const std::vector<float>& distance = attempt.goal.distance[target];
  // While the tip still rests on the target before, this one is not sought.
  if (target > 0)
    for (const std::vector<float>& before = attempt.goal.distance[target - 1];
         from < before.size() && double(before[from]) <= goal.radius;)
      ++from;
  std::size_t nearest = from, longest = 0, since = from, inside = 0;
  for (std::size_t f = from; f < distance.size(); ++f) {
    if (distance[f] < distance[nearest]) nearest = f;
    inside = double(distance[f]) <= goal.radius ? inside + 1 : 0;
    if (inside > longest) longest = inside, since = f + 1 - inside;
  }
  const std::size_t number = target + 1;
  if (from >= distance.size())
    return {fmt::format(" Target {} was not begun.", number), attempt.duration()};
  if (longest > 0)
    return {fmt::format(" Target {} was held for {:.1f} s at most.", number,
                        attempt.interval * double(longest)),
            attempt.time[since]};
  if (std::isfinite(distance[nearest]))
    return {fmt::format(" The tip came no nearer than {:.0f} mm to target {}; {:g} mm is near "
                        "enough.",
                        1e3 * double(distance[nearest]), number, 1e3 * goal.radius),
            attempt.time[nearest]};
  // Nothing touched any more: the middle of that time shows the search.
  return {fmt::format(" Target {} was not touched.", number),
          attempt.time[from + (distance.size() - from) / 2]};
}

GoalResult touchResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  const auto frames = std::size_t(std::max(1.0, std::round(goal.hold / attempt.interval)));
  std::size_t held = 0, from = 0;
  double drift = 0;
  for (; held < attempt.goal.distance.size(); ++held) {
    const std::vector<float>& distance = attempt.goal.distance[held];
    std::size_t inside = 0, f = from;
    for (; f < distance.size() && inside < frames; ++f)
      inside = double(distance[f]) <= goal.radius ? inside + 1 : 0;
    if (inside < frames) break;
    for (std::size_t k = f - frames; k < f; ++k) drift = std::max(drift, double(distance[k]));
    result.time = attempt.time[f - 1];
    from = f;
  }
  const std::size_t targets = attempt.goal.distance.size();
  result.reached = targets > 0 && held == targets;
  result.done = targets > 0 ? double(held) / double(targets) : 0;
  result.measures.push_back({"targets_held", "", double(held)});
  if (held > 0) result.measures.push_back({"drift_mm", "", 1e3 * drift});
  if (result.reached) {
    result.sentence = fmt::format("All {} targets were touched and held.", targets);
    return result;
  }
  result.sentence =
      fmt::format("{} of {} targets were touched and held for {:g} s.", held, targets, goal.hold);
  if (held >= targets) return result;
  const Missed missed = missedTarget(attempt, goal, held, from);
  result.time = missed.time;
  result.sentence += missed.sentence;
  return result;
}

GoalResult resectResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  const auto best = std::ranges::max_element(attempt.specimens, {}, &Specimen::target);
  const double taken = best == attempt.specimens.end() ? 0 : best->target;
  const double left = std::max(0.0, attempt.targetBefore - taken);
  const bool whole = attempt.targetBefore > 0 && left < 1e-3 * attempt.targetBefore;
  result.measures.push_back({"target_left_ml", "", 1e6 * left});
  if (attempt.margin) result.measures.push_back({"margin_mm", "", 1e3 * *attempt.margin});
  result.reached = whole && attempt.margin && *attempt.margin >= goal.margin;
  // Half of it is the structure, the other half its margin.
  result.done = attempt.targetBefore > 0 ? 0.5 * taken / attempt.targetBefore : 0;
  if (whole)
    result.done = result.reached ? 1 : 0.5 + 0.5 * attempt.margin.value_or(0) / goal.margin;
  if (!whole)
    result.sentence = fmt::format(
        "The {} did not come out in one piece: {:.1f} of {:.1f} ml were "
        "left behind.",
        goal.structure, 1e6 * left, 1e6 * attempt.targetBefore);
  else
    result.sentence = fmt::format(
        "The {} came out in one piece of {:.0f} ml; the smallest margin is {:.1f} mm, wanted are "
        "{:g} mm.",
        goal.structure, 1e6 * best->volume, 1e3 * attempt.margin.value_or(0), 1e3 * goal.margin);
  return result;
}

GoalResult stopResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  const auto worst = worstBleeding(attempt);
  if (!worst) {
    result.sentence = "Nothing bled, so nothing was stopped.";
    return result;
  }
  const double most = bleedingRate(attempt, *worst);
  if (most < goal.from) {
    result.time = attempt.time[*worst];
    result.sentence = fmt::format(
        "It bled at {:.0f} ml/min at most; a bleeding of {:g} ml/min or more was to be stopped.",
        60e6 * most, 60e6 * goal.from);
    return result;
  }
  const auto first = std::ranges::find_if(attempt.bled, [](double b) { return b > 0; });
  const auto start = std::size_t(first - attempt.bled.begin());
  std::size_t stopped = attempt.bled.size();
  while (stopped > start && bleedingRate(attempt, stopped - 1) < goal.rate) --stopped;
  const bool still = stopped < attempt.bled.size();
  const double quiet = still ? attempt.duration() - attempt.time[stopped] : 0;
  result.reached = still && quiet >= goal.hold;
  result.time = still ? attempt.time[stopped] : attempt.duration();
  const double rate = bleedingRate(attempt, attempt.bled.size() - 1);
  if (result.reached) {
    // Only a bleeding that was stopped has a time until it was.
    const double took = *result.time - attempt.time[start];
    result.done = 1;
    result.measures.push_back({"bleeding_s", "", took});
    result.sentence = fmt::format(
        "The bleeding was stopped {:.1f} s after it began; {:.0f} ml "
        "were lost.",
        took, 1e6 * attempt.bled.back());
    return result;
  }
  constexpr double kNearly = 0.9;  // of a bleeding that has not been quiet for long enough
  if (most > goal.rate)
    result.done = kNearly * std::clamp((most - rate) / (most - goal.rate), 0.0, 1.0);
  result.sentence =
      still ? fmt::format(
                  "The bleeding was below {:g} ml/min for the last {:.1f} s only; {:g} s "
                  "are wanted.",
                  60e6 * goal.rate, quiet, goal.hold)
            : fmt::format(
                  "It still bled at {:.0f} ml/min at the end (grade {} of 4); less than "
                  "{:g} ml/min for {:g} s is wanted.",
                  60e6 * rate, bleedingGrade(rate), 60e6 * goal.rate, goal.hold);
  return result;
}

GoalResult divideResult(const Attempt& attempt, const TaskGoal& goal) {
  constexpr double kNear = 0.02;  // m: the vessel may be divided so far from the place
  GoalResult result;
  const std::vector<Vec3>& places = attempt.goal.restPlaces;
  const Vec3 place = places.empty() ? Vec3(Vec3::Zero()) : places[0];
  const VesselStory* vessel = nullptr;
  for (const VesselStory& v : attempt.vessels)
    if (v.severed && v.kind == goal.vessel && v.diameter >= goal.thinnest &&
        (v.place - place).norm() < kNear &&
        (!vessel || (v.place - place).norm() < (vessel->place - place).norm()))
      vessel = &v;
  // Three steps: a clip, another one, the cut. A vessel that was cut gets no more of them.
  if (!vessel) {
    const auto clips = std::ranges::count_if(
        attempt.clips, [&](const ClipPlaced& c) { return (c.place - place).norm() < kNear; });
    result.done = double(std::min<std::ptrdiff_t>(clips, 2)) / 3;
    result.sentence = fmt::format("The {} was not divided.", nameOf(goal.vessel));
    return result;
  }
  result.time = vessel->cut;
  result.reached = vessel->clippedRoot && vessel->clippedFar;
  result.done = result.reached ? 1 : double(int(vessel->clippedRoot) + vessel->clippedFar) / 3;
  const char* which = vessel->clippedRoot ? "the far side" : "the side of the heart";
  result.sentence =
      result.reached
          ? fmt::format("The {} of {:.1f} mm was divided between two clips.", vessel->name,
                        1e3 * vessel->diameter)
          : fmt::format("The {} of {:.1f} mm was cut without a clip on {}.", vessel->name,
                        1e3 * vessel->diameter,
                        vessel->clippedRoot || vessel->clippedFar ? which : "either side");
  return result;
}

GoalResult transectResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  double near = 0;
  if (!attempt.goal.work.empty()) {
    const OffLine off = offLine(attempt);
    near = off.most;
    result.measures.push_back({"off_plane_mm", "", 1e3 * off.mean});
    result.measures.push_back({"off_plane_most_mm", "", 1e3 * off.most});
    result.time = off.time;
  }
  if (attempt.specimens.empty()) {
    if (!attempt.goal.work.empty()) result.time = attempt.time[attempt.goal.work.back().frame];
    result.sentence = "No part came off.";
    return result;
  }
  // Half of it is the part, the other half its plane.
  result.reached = near <= goal.radius;
  result.done = result.reached ? 1 : 0.5 + 0.5 * goal.radius / near;
  result.sentence = fmt::format(
      "A part of {:.0f} ml came off; the cut strayed from the plane by at most {:.1f} mm, allowed "
      "are {:g} mm.",
      1e6 * attempt.specimens[0].volume, 1e3 * near, 1e3 * goal.radius);
  return result;
}

}  // namespace

GoalResult goalResult(const Attempt& attempt) {
  require(attempt.task.has_value(), "{}: has no task to be scored by; give one", attempt.file);
  const TaskGoal& goal = attempt.task->goal;
  switch (goal.kind) {
    case Kind::Touch:
      return touchResult(attempt, goal);
    case Kind::Follow:
      return followResult(attempt, goal);
    case Kind::Resect:
      return resectResult(attempt, goal);
    case Kind::StopBleeding:
      return stopResult(attempt, goal);
    case Kind::Divide:
      return divideResult(attempt, goal);
    case Kind::Transect:
      return transectResult(attempt, goal);
  }
  throw usageError("there is no goal {}", int(goal.kind));
}

std::string goalSentence(const Task& task) {
  const TaskGoal& goal = task.goal;
  switch (goal.kind) {
    case Kind::Touch:
      return fmt::format("Touch {} targets in turn, and hold each for {:g} s within {:g} mm.",
                         goal.places.size(), goal.hold, 1e3 * goal.radius);
    case Kind::Follow:
      if (goal.holdWith.empty()) return fmt::format("Cut along the line, {}.", nearText(task));
      return fmt::format("Cut along the line, {}, while the other hand holds the tissue.",
                         nearText(task));
    case Kind::Resect:
      return fmt::format("Take out the {} in one piece, with a margin of {:g} mm on all sides.",
                         goal.structure, 1e3 * goal.margin);
    case Kind::StopBleeding:
      return fmt::format(
          "Stop a bleeding of {:g} ml/min or more: bring it below {:g} ml/min, for {:g} s.",
          60e6 * goal.from, 60e6 * goal.rate, goal.hold);
    case Kind::Divide:
      return fmt::format("Divide the {} between two clips.", nameOf(goal.vessel));
    case Kind::Transect:
      return fmt::format("Part the organ along the plane, no farther than {:g} mm from it.",
                         1e3 * goal.radius);
  }
  return "";
}

}  // namespace resect
