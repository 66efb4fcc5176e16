#include "skills/score/goal_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "blood/bleeding.h"

namespace resect {
namespace {

using Kind = TaskGoal::Kind;

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
  result.measures.push_back({"targets_held", "", double(held)});
  if (held > 0) result.measures.push_back({"drift_mm", "", 1e3 * drift});
  result.sentence = result.reached
                        ? fmt::format("All {} targets were touched and held.", targets)
                        : fmt::format("{} of {} targets were touched and held for {:g} s.", held,
                                      targets, goal.hold);
  return result;
}

// The share of a line near which the instrument worked: between the places of two frames that
// follow each other it is taken to have worked all the way.
double coveredShare(const GoalTrace& trace, double radius) {
  constexpr double kBin = 0.001;  // m
  const auto bins = std::size_t(std::max(1.0, std::ceil(trace.lineLength / kBin)));
  std::vector<char> covered(bins, 0);
  const auto binOf = [&](double along) {
    return std::min(bins - 1, std::size_t(std::max(0.0, along / kBin)));
  };
  for (std::size_t i = 0; i < trace.work.size(); ++i) {
    if (trace.work[i].off > radius) continue;
    const std::size_t here = binOf(trace.work[i].along);
    const bool follows = i > 0 && trace.work[i].frame - trace.work[i - 1].frame <= 2 &&
                         trace.work[i - 1].off <= radius;
    const std::size_t before = follows ? binOf(trace.work[i - 1].along) : here;
    for (std::size_t b = std::min(here, before); b <= std::max(here, before); ++b) covered[b] = 1;
  }
  return double(std::ranges::count(covered, 1)) / double(bins);
}

// Mean and largest distance of the work from line or plane, m, and when it was largest.
struct Off {
  double mean = 0, most = 0, time = 0;
};
Off offOf(const Attempt& attempt) {
  Off off;
  for (const WorkMoment& w : attempt.goal.work) {
    off.mean += w.off / double(attempt.goal.work.size());
    if (w.off > off.most) off.most = w.off, off.time = attempt.time[w.frame];
  }
  return off;
}

GoalResult followResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  const double covered = coveredShare(attempt.goal, goal.radius);
  result.measures.push_back({"line_covered_pct", "", 100 * covered});
  if (!attempt.goal.work.empty()) {
    const Off off = offOf(attempt);
    result.measures.push_back({"off_line_mm", "", 1e3 * off.mean});
    result.measures.push_back({"off_line_most_mm", "", 1e3 * off.most});
    result.time = off.time;
  }
  if (!goal.holdWith.empty() && !attempt.goal.work.empty()) {
    const auto held = std::ranges::count_if(
        attempt.goal.work, [&](const WorkMoment& w) { return attempt.goal.held[w.frame] != 0; });
    result.measures.push_back(
        {"held_pct", "", 100 * double(held) / double(attempt.goal.work.size())});
  }
  result.reached = covered >= kLineFollowed;
  result.sentence =
      attempt.goal.work.empty()
          ? "The line was not cut at all."
          : fmt::format("{:.0f} % of the line was followed within {:g} mm; {:.0f} % is wanted.",
                        100 * covered, 1e3 * goal.radius, 100 * kLineFollowed);
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
  const auto first = std::ranges::find_if(attempt.bled, [](double b) { return b > 0; });
  if (first == attempt.bled.end()) {
    result.sentence = "Nothing bled, so nothing was stopped.";
    return result;
  }
  const auto start = std::size_t(first - attempt.bled.begin());
  std::size_t stopped = attempt.bled.size();
  while (stopped > start && bleedingRate(attempt, stopped - 1) < goal.rate) --stopped;
  const bool still = stopped < attempt.bled.size();
  const double quiet = still ? attempt.duration() - attempt.time[stopped] : 0;
  result.reached = still && quiet >= goal.hold;
  const double end = still ? attempt.time[stopped] : attempt.duration();
  result.time = end;
  result.measures.push_back({"bleeding_s", "", end - attempt.time[start]});
  const double rate = 60e6 * bleedingRate(attempt, attempt.bled.size() - 1);
  result.sentence =
      result.reached
          ? fmt::format("The bleeding was stopped {:.1f} s after it began; {:.0f} ml were lost.",
                        end - attempt.time[start], 1e6 * attempt.bled.back())
          : fmt::format(
                "It still bled at {:.0f} ml/min at the end (grade {} of 4); less than "
                "{:g} ml/min for {:g} s is wanted.",
                rate, bleedingGrade(rate / 60e6), 60e6 * goal.rate, goal.hold);
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
  if (!vessel) {
    result.sentence = fmt::format("The {} was not divided.", nameOf(goal.vessel));
    return result;
  }
  result.time = vessel->cut;
  result.reached = vessel->clippedRoot && vessel->clippedFar;
  const char* which = vessel->clippedRoot ? "the far side" : "the side of the heart";
  result.sentence =
      result.reached
          ? fmt::format("The {} of {:.1f} mm was divided between two clips.", nameOf(vessel->kind),
                        1e3 * vessel->diameter)
          : fmt::format("The {} of {:.1f} mm was cut without a clip on {}.", nameOf(vessel->kind),
                        1e3 * vessel->diameter,
                        vessel->clippedRoot || vessel->clippedFar ? which : "either side");
  return result;
}

GoalResult transectResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  if (!attempt.goal.work.empty()) {
    const Off off = offOf(attempt);
    result.measures.push_back({"off_plane_mm", "", 1e3 * off.mean});
    result.measures.push_back({"off_plane_most_mm", "", 1e3 * off.most});
    result.time = off.time;
  }
  const double near = attempt.goal.work.empty() ? 0 : 1e-3 * result.measures[1].value;
  const bool off = !attempt.specimens.empty();
  result.reached = off && near <= goal.radius;
  result.sentence =
      off ? fmt::format(
                "A part of {:.0f} ml came off; the cut strayed from the plane by at most "
                "{:.1f} mm, allowed are {:g} mm.",
                1e6 * attempt.specimens[0].volume, 1e3 * near, 1e3 * goal.radius)
          : "No part came off.";
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
      return fmt::format("Cut along the line, no farther than {:g} mm from it{}.",
                         1e3 * goal.radius,
                         goal.holdWith.empty() ? "" : ", while the other hand holds the tissue");
    case Kind::Resect:
      return fmt::format("Take out the {} in one piece, with a margin of {:g} mm on all sides.",
                         goal.structure, 1e3 * goal.margin);
    case Kind::StopBleeding:
      return fmt::format("Stop the bleeding: less than {:g} ml/min for {:g} s.", 60e6 * goal.rate,
                         goal.hold);
    case Kind::Divide:
      return fmt::format("Divide the {} between two clips.", nameOf(goal.vessel));
    case Kind::Transect:
      return fmt::format("Part the organ along the plane, no farther than {:g} mm from it.",
                         1e3 * goal.radius);
  }
  return "";
}

}  // namespace resect
