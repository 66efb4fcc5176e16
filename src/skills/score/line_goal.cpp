#include "skills/score/line_goal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace resect {
namespace {

// How far from a line an instrument may work, m.
double farthestOff(const Task& task) {
  const auto most = mostOf(task, "off_line_most_mm");
  return most ? 1e-3 * *most : task.goal.radius;
}

constexpr double kBin = 0.001;  // m: of a line

// For each millimetre of a line whether the instrument worked near it: between the places of two
// frames that follow each other it is taken to have worked all the way.
std::vector<char> coveredBins(const GoalTrace& trace, double radius) {
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
  return covered;
}

// Stretches of a line that were not followed, the longest first, in bins: first and one past last.
using Stretch = std::pair<std::size_t, std::size_t>;
std::vector<Stretch> stretchesWithout(const std::vector<char>& covered) {
  std::vector<Stretch> missing;
  for (std::size_t b = 0; b < covered.size(); ++b) {
    if (covered[b]) continue;
    if (missing.empty() || missing.back().second != b) missing.emplace_back(b, b);
    missing.back().second = b + 1;
  }
  std::ranges::stable_sort(missing, std::greater<>(),
                           [](const Stretch& s) { return s.second - s.first; });
  return missing;
}

// "20 to 28 mm and 51 to 60 mm": the longest three, in their order along the line.
std::string stretchText(std::vector<Stretch> missing) {
  missing.resize(std::min<std::size_t>(missing.size(), 3));
  std::ranges::sort(missing);
  std::string text;
  for (const Stretch& s : missing)
    text += fmt::format("{}{} to {} mm", text.empty() ? "" : " and ", s.first, s.second);
  return text;
}

// When work was nearest to the middle of a stretch of the line, along it.
double timeNear(const Attempt& attempt, const Stretch& stretch) {
  const double middle = 0.5 * kBin * double(stretch.first + stretch.second);
  const auto nearest = std::ranges::min_element(
      attempt.goal.work, {}, [&](const WorkMoment& w) { return std::abs(w.along - middle); });
  return attempt.time[nearest->frame];
}

}  // namespace

OffLine offLine(const Attempt& attempt) {
  OffLine off;
  for (const WorkMoment& w : attempt.goal.work) {
    off.mean += w.off / double(attempt.goal.work.size());
    if (w.off > off.most) off.most = w.off, off.time = attempt.time[w.frame];
  }
  return off;
}

std::string nearText(const Task& task) {
  const double strip = 1e3 * task.goal.radius, most = 1e3 * farthestOff(task);
  if (std::abs(strip - most) < 1e-6) return fmt::format("no farther than {:g} mm from it", most);
  return fmt::format("{:.0f} % of it within {:g} mm and nowhere farther than {:g} mm from it",
                     100 * kLineFollowed, strip, most);
}

GoalResult followResult(const Attempt& attempt, const TaskGoal& goal) {
  GoalResult result;
  const std::vector<char> bins = coveredBins(attempt.goal, goal.radius);
  const double covered = double(std::ranges::count(bins, 1)) / double(bins.size());
  result.measures.push_back({"line_covered_pct", "", 100 * covered});
  if (attempt.goal.work.empty()) {
    result.sentence = "The line was not cut at all.";
    return result;
  }
  const OffLine off = offLine(attempt);
  result.measures.push_back({"off_line_mm", "", 1e3 * off.mean});
  result.measures.push_back({"off_line_most_mm", "", 1e3 * off.most});
  if (!goal.holdWith.empty()) {
    const auto held = std::ranges::count_if(
        attempt.goal.work, [&](const WorkMoment& w) { return attempt.goal.held[w.frame] != 0; });
    result.measures.push_back(
        {"held_pct", "", 100 * double(held) / double(attempt.goal.work.size())});
  }
  const std::vector<Stretch> missing = stretchesWithout(bins);
  const bool whole = covered >= kLineFollowed;
  const double allowed = farthestOff(*attempt.task);
  // A limit of the task on this is a check of its own.
  const bool strayed = off.most > allowed && !mostOf(*attempt.task, "off_line_most_mm");
  result.missing = stretchText(missing);
  for (const auto& [from, to] : missing)
    result.unfollowed.emplace_back(kBin * double(from), kBin * double(to));
  result.reached = whole && !strayed;
  result.done = std::min(1.0, covered / kLineFollowed) * (strayed ? allowed / off.most : 1);
  result.time = whole || missing.empty() ? off.time : timeNear(attempt, missing[0]);
  result.sentence = fmt::format(
      "{:.0f} % of the line was followed within {:g} mm{}.", 100 * covered, 1e3 * goal.radius,
      whole ? "" : fmt::format("; {:.0f} % is wanted", 100 * kLineFollowed));
  if (!missing.empty())
    result.sentence += fmt::format(" Not followed: {} from its beginning.", result.missing);
  if (strayed)
    result.sentence += fmt::format(
        " The instrument went {:.0f} mm from the line; {:g} mm is "
        "allowed.",
        1e3 * off.most, 1e3 * allowed);
  return result;
}

}  // namespace resect
