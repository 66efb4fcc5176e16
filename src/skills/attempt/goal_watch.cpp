#include "skills/attempt/goal_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "tools/rest_place.h"

namespace resect {
namespace {

constexpr double kLineStep = 0.003;    // m between the points of a line that are followed
constexpr int kMostLinePoints = 2000;  // of a longer line they are farther apart

// The points of a line through `corners`, on the surface where the corners lie on it.
std::vector<TissuePoint> denseLine(const std::vector<TaskPlace>& places, const Organ& organ) {
  const std::vector<TissuePoint> corners = goalPlaces(places, organ);
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i)
    length += (corners[i].rest - corners[i - 1].rest).norm();
  const double step = std::max(kLineStep, length / kMostLinePoints);
  std::vector<TaskPlace> dense;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i].rest, b = corners[std::min(i + 1, corners.size() - 1)].rest;
    const int steps = i + 1 < corners.size() ? 1 + int((b - a).norm() / step) : 1;
    for (int k = 0; k < steps; ++k) {
      TaskPlace place;
      place.place = a + double(k) / steps * (b - a);
      place.inWorld = true;
      place.depth = places[i].depth;
      dense.push_back(place);
    }
  }
  return goalPlaces(dense, organ);
}

constexpr double kShaft = 0.1;  // m: of an instrument, from its tip

struct LinePlace {
  double along = 0, off = 0;
};

// The place of the line to which the instrument is nearest. Its shaft counts and not only its tip,
// for a blade goes in below the line.
LinePlace placeOn(const std::vector<TissuePoint>& line, const std::vector<double>& along,
                  const ToolMoment& tool, const Vec3& axis) {
  const Vec3 end = tool.tip + kShaft * (tool.turn * axis);
  LinePlace best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 &a = line[i].rest, &b = line[i + 1].rest;
    const double off = segmentDistance(tool.tip, end, a, b);
    if (off >= best.off) continue;
    const double share = nearestPlaces(tool.tip, end, a, b).second;
    best = {along[i] + share * (along[i + 1] - along[i]), off};
  }
  return best;
}

}  // namespace

std::size_t goalOrgan(const TaskGoal& goal, const Scenario& scenario) {
  for (std::size_t o = 0; o < scenario.organs.size(); ++o)
    if (scenario.organs[o].source.name == goal.organ) return o;
  return 0;
}

GoalWatch::GoalWatch(const TaskGoal& goal, const Scenario& scenario, const Simulation& simulation)
    : goal_(goal), organ_(goalOrgan(goal, scenario)) {
  const OperatedOrgan& organ = simulation.organs()[organ_];
  requireFits(goal, organ);
  points_ = goal.kind == TaskGoal::Kind::Follow ? denseLine(goal.places, organ.organ)
                                                : goalPlaces(goal.places, organ.organ);
  for (std::size_t i = 0; i < points_.size(); ++i)
    along_.push_back(i == 0 ? 0.0 : along_[i - 1] + (points_[i].rest - points_[i - 1].rest).norm());
}

bool GoalWatch::counts(const InstrumentRecord& instrument) const {
  return goal_.with.empty() || instrument.model == goal_.with;
}

void GoalWatch::addDistances(Attempt& attempt) const {
  attempt.goal.distance.resize(present_.size());
  for (std::size_t t = 0; t < present_.size(); ++t) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const InstrumentRecord& one : attempt.instruments)
      if (const ToolMoment& m = one.moments.back(); m.inHand && counts(one))
        nearest = std::min(nearest, float((m.tip - present_[t].rest).norm()));
    attempt.goal.distance[t].push_back(nearest);
  }
}

void GoalWatch::addWork(const Simulation& simulation, Attempt& attempt) const {
  const OperatedOrgan& organ = simulation.organs()[organ_];
  for (const InstrumentRecord& one : attempt.instruments) {
    const ToolMoment& m = one.moments.back();
    if (!m.inHand || !m.works || !counts(one) || one.model == goal_.holdWith) continue;
    WorkMoment work{attempt.time.size() - 1, 0, 0};
    if (goal_.kind == TaskGoal::Kind::Follow) {
      const LinePlace place = placeOn(present_, along_, m, one.axis);
      work.along = place.along, work.off = place.off;
    } else {
      // A plane is one of the tissue at rest.
      const auto rest = restPlace(organ.organ, *organ.tissue, m.tip);
      if (!rest) continue;
      work.off = std::abs((*rest - points_[0].rest).dot(goal_.normal));
    }
    attempt.goal.work.push_back(work);
  }
}

void GoalWatch::add(const Simulation& simulation, Attempt& attempt) {
  using enum TaskGoal::Kind;
  if (points_.empty() && goal_.kind != Resect) return;
  present_.clear();
  for (const TissuePoint& point : points_)
    present_.push_back(presentPoint(point, simulation.organs()[organ_]));
  if (attempt.goal.restPlaces.empty())
    for (const TissuePoint& point : points_) attempt.goal.restPlaces.push_back(point.rest);
  attempt.goal.lineLength = along_.empty() ? 0 : along_.back();
  begun_ = begun_ || std::ranges::any_of(attempt.instruments,
                                         [](const auto& one) { return one.moments.back().works; });
  if (!begun_ || attempt.goal.places.empty()) {
    attempt.goal.places.clear();
    for (const TissuePoint& point : present_) attempt.goal.places.push_back(point.rest);
  }
  if (goal_.kind == Touch) addDistances(attempt);
  if (goal_.kind == Follow || goal_.kind == Transect) addWork(simulation, attempt);
  if (goal_.holdWith.empty()) return;
  attempt.goal.held.push_back(std::ranges::any_of(attempt.instruments, [&](const auto& one) {
    return one.model == goal_.holdWith && one.moments.back().grips;
  }));
}

void GoalWatch::rewind(std::size_t frames, Attempt& attempt) const {
  for (std::vector<float>& distance : attempt.goal.distance) distance.resize(frames);
  std::erase_if(attempt.goal.work, [&](const WorkMoment& w) { return w.frame >= frames; });
  if (attempt.goal.held.size() > frames) attempt.goal.held.resize(frames);
}

}  // namespace resect
