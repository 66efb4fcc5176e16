#include "skills/report/debrief_charts.h"

#include <fmt/format.h>

#include <algorithm>

#include "skills/report/chart.h"
#include "skills/report/html.h"
#include "skills/score/findings.h"

namespace resect {
namespace {

std::vector<ChartMark> marksOf(const Verdict& verdict) {
  std::vector<ChartMark> marks;
  for (std::size_t i = 0; i < verdict.deductions.size(); ++i)
    if (verdict.deductions[i].time)
      marks.push_back({*verdict.deductions[i].time, fmt::format("{}", i + 1)});
  std::ranges::stable_sort(marks, {}, &ChartMark::time);
  return marks;
}

TimeChart forceChart(const Attempt& attempt) {
  TimeChart chart{"Force", "N", attempt.duration(), {}, {}, {}};
  if (const auto limit = attempt.task ? forceLimitOf(*attempt.task) : std::nullopt)
    chart.limit = limit->force;
  for (std::size_t t = 0; t < attempt.instruments.size(); ++t) {
    const InstrumentRecord& one = attempt.instruments[t];
    if (!std::ranges::any_of(one.moments, &ToolMoment::inHand)) continue;
    ChartCurve curve{one.name, chartColour(t), {}};
    for (std::size_t f = 0; f < attempt.time.size(); ++f)
      curve.points.emplace_back(attempt.time[f], one.moments[f].inHand ? one.moments[f].force : 0);
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

TimeChart bloodChart(const Attempt& attempt) {
  TimeChart chart{"Blood lost", "ml", attempt.duration(), {{"", "#b3362b", {}}}, {}, {}};
  for (std::size_t f = 0; f < attempt.bled.size(); ++f)
    chart.curves[0].points.emplace_back(attempt.time[f], 1e6 * attempt.bled[f]);
  return chart;
}

TimeChart rateChart(const Attempt& attempt) {
  TimeChart chart{"Bleeding", "ml/min", attempt.duration(), {{"", "#8a5a00", {}}}, {}, {}};
  for (std::size_t f = 0; f < attempt.bled.size(); ++f)
    chart.curves[0].points.emplace_back(attempt.time[f], 60e6 * bleedingRate(attempt, f));
  return chart;
}

TimeChart tissueChart(const Attempt& attempt) {
  TimeChart chart{"Tissue", "ml", attempt.duration(), {}, {}, {}};
  chart.curves = {{"in pieces that came off", "#2166a5", {}}, {"destroyed", "#b3362b", {}}};
  for (const TissueMoment& m : attempt.tissue) {
    chart.curves[0].points.emplace_back(m.time, 1e6 * m.pieces);
    chart.curves[1].points.emplace_back(m.time, 1e6 * m.removed);
  }
  return chart;
}

TimeChart cutChart(const Attempt& attempt) {
  TimeChart chart{"Area cut", "cm2", attempt.duration(), {{"", "#1f7a4d", {}}}, {}, {}};
  for (const TissueMoment& m : attempt.tissue)
    chart.curves[0].points.emplace_back(m.time, 1e4 * m.cut);
  return chart;
}

bool changes(const TimeChart& chart) {
  return std::ranges::any_of(chart.curves, [](const ChartCurve& curve) {
    return std::ranges::any_of(curve.points, [](const auto& p) { return p.y() > 0; });
  });
}

// What happened besides, as lines with their times.
std::string happenings(const Attempt& attempt) {
  struct Line {
    double time;
    std::string text;
  };
  std::vector<Line> lines;
  for (const ClipPlaced& clip : attempt.clips)
    lines.push_back({clip.time, fmt::format("a clip was placed on the {} of {:.1f} mm", clip.vessel,
                                            1e3 * clip.diameter)});
  for (const VesselStory& v : attempt.vessels) {
    if (v.diameter < kNotableVessel) continue;
    if (!v.before)
      lines.push_back({v.cut, fmt::format("{} of {:.1f} mm cut, {}", v.name, 1e3 * v.diameter,
                                          v.clippedRoot ? "clipped before" : "not clipped")});
    if (v.closed && !v.clippedRoot)
      lines.push_back({*v.closed, fmt::format("{} of {:.1f} mm closed", v.name, 1e3 * v.diameter)});
  }
  if (const auto work = workOf(attempt)) {
    lines.push_back({attempt.time[work->first], "first contact"});
    lines.push_back({attempt.time[work->last], "last contact"});
  }
  std::ranges::stable_sort(lines, {}, &Line::time);
  std::vector<std::string> items;
  for (const Line& one : lines)
    items.push_back(fmt::format("<time>{}</time> {}", timeText(one.time), htmlText(one.text)));
  return htmlList(items);
}

constexpr const char* kUnfollowed = "#e0007a";

// The stretches of a line that were not followed, as places in the world.
std::vector<std::vector<Vec3>> unfollowedPlaces(const GoalTrace& trace, const GoalResult& goal) {
  std::vector<std::vector<Vec3>> stretches;
  for (const auto& [from, to] : goal.unfollowed) {
    std::vector<Vec3> stretch;
    double along = 0;
    for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
      const double length = (trace.restPlaces[i + 1] - trace.restPlaces[i]).norm();
      const double a = std::clamp((from - along) / length, 0.0, 1.0),
                   b = std::clamp((to - along) / length, 0.0, 1.0);
      const auto at = [&](double share) {
        return Vec3(trace.places[i] + share * (trace.places[i + 1] - trace.places[i]));
      };
      if (length > 0 && b > a) stretch.push_back(at(a)), stretch.push_back(at(b));
      along += length;
    }
    stretches.push_back(std::move(stretch));
  }
  return stretches;
}

}  // namespace

std::string timelines(const Scored& scored) {
  const Attempt& attempt = scored.attempt;
  std::vector<TimeChart> charts;
  if (attempt.tissueMoves) charts.push_back(forceChart(attempt));
  if (attempt.bleeds) charts.push_back(bloodChart(attempt)), charts.push_back(rateChart(attempt));
  charts.push_back(tissueChart(attempt));
  charts.push_back(cutChart(attempt));
  std::string html;
  for (TimeChart& chart : charts) {
    if (!changes(chart)) continue;
    chart.marks = marksOf(scored.verdict);
    html += "<figure class=\"wide\">" + toSvg(chart) + "</figure>\n";
  }
  return html + happenings(attempt);
}

std::string pathViews(const Scored& scored) {
  const Attempt& attempt = scored.attempt;
  const std::vector<std::vector<Vec3>> unfollowed =
      unfollowedPlaces(attempt.goal, scored.verdict.goal);
  PathView views[] = {{"From the surgeon: right, up", 0, 1, false, {}, {}, 0},
                      {"From above: right, towards the surgeon", 0, 2, true, {}, {}, 0},
                      {"From the right: towards the surgeon, up", 2, 1, false, {}, {}, 0}};
  std::string html = "<div class=\"row\">\n";
  std::string names;
  for (PathView& view : views) {
    const auto seen = [&](const Vec3& p) { return Eigen::Vector2d(p[view.across], p[view.up]); };
    for (const Vec3& place : attempt.goal.places) view.places.push_back(seen(place));
    const bool targets = attempt.task && attempt.task->goal.kind == TaskGoal::Kind::Touch;
    view.radius = targets ? attempt.task->goal.radius : 0;
    for (std::size_t t = 0; t < attempt.instruments.size(); ++t)
      for (const Track& track : tracksOf(attempt, attempt.instruments[t])) {
        ChartCurve curve{attempt.instruments[t].name, chartColour(t), {}};
        for (const Vec3& tip : track.tip) curve.points.push_back(seen(tip));
        view.curves.push_back(std::move(curve));
      }
    for (const std::vector<Vec3>& stretch : unfollowed) {
      ChartCurve curve{"not followed", kUnfollowed, {}};
      for (const Vec3& place : stretch) curve.points.push_back(seen(place));
      view.curves.push_back(std::move(curve));
    }
    html += htmlFigure(toSvg(view), view.title);
  }
  for (std::size_t t = 0; t < attempt.instruments.size(); ++t)
    if (!tracksOf(attempt, attempt.instruments[t]).empty())
      names += fmt::format("<span style=\"color:{}\">&#9644; {}</span> ", chartColour(t),
                           htmlText(attempt.instruments[t].name));
  TurningView turning{"The paths in space, turning", {}, {}, attempt.goal.places, 0};
  if (attempt.task && attempt.task->goal.kind == TaskGoal::Kind::Touch)
    turning.radius = attempt.task->goal.radius;
  for (std::size_t t = 0; t < attempt.instruments.size(); ++t)
    for (const Track& track : tracksOf(attempt, attempt.instruments[t]))
      turning.curves.push_back({chartColour(t), track.tip});
  for (const std::vector<Vec3>& stretch : unfollowed)
    turning.curves.push_back({kUnfollowed, stretch});
  const std::string figure =
      turning.curves.empty()
          ? ""
          : htmlFigure(toSvg(turning), "In space; it turns, and stops under the pointer.");
  const char* green = attempt.goal.places.empty() ? "" : "Green: the task's places.";
  const std::string red =
      unfollowed.empty()
          ? ""
          : fmt::format(" <span style=\"color:{}\">&#9644; not followed</span>", kUnfollowed);
  return html + "</div>\n" + figure + "<p class=\"quiet\">" + names + green + red + "</p>\n";
}

std::string marginSection(const Attempt& attempt) {
  if (attempt.margins.empty()) return "";
  const double wanted = attempt.task->goal.margin;
  TurningView view{"The cut round the structure, turning",
                   {},
                   {{"#b3362b", {}}, {"#d08a00", {}}, {"#2166a5", {}}},
                   {attempt.targetMiddle},
                   attempt.targetReach};
  for (const MarginPlace& one : attempt.margins)
    view.dots[one.distance < 0.5 * wanted ? 0
              : one.distance < wanted     ? 1
                                          : 2]
        .points.push_back(one.place);
  const std::string least =
      attempt.margin ? fmt::format(" The smallest margin is {:.1f} mm.", 1e3 * *attempt.margin)
                     : "";
  return htmlSection(
      "How near the cut came",
      htmlFigure(toSvg(view),
                 fmt::format("Each dot is a place of the cut, in the organ at rest; it turns, and "
                             "stops under the pointer. Green: the {}.",
                             attempt.task->goal.structure)) +
          fmt::format("<p><span style=\"color:#b3362b\">&#9679;</span> nearer than {:g} mm "
                      "<span style=\"color:#d08a00\">&#9679;</span> nearer than {:g} mm "
                      "<span style=\"color:#2166a5\">&#9679;</span> as wanted.{}</p>\n",
                      500 * wanted, 1e3 * wanted, least));
}

}  // namespace resect
