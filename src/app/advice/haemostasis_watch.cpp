#include "app/advice/haemostasis_watch.h"

#include <algorithm>
#include <cmath>

#include "app/language/words.h"
#include "tools/parts/bipolar_part.h"
#include "tools/parts/clip_part.h"

namespace resect {
namespace {

constexpr double kStopped = 0.2;        // of the flow before: an end that bleeds less is closed
constexpr double kNothing = 1e-7 / 60;  // m^3/s, 0.1 ml/min: a smaller change is none
constexpr double kBegun = 0.05;         // squeeze of jaws that somebody has begun to close
constexpr double kSteady = 0.3;         // s after which the flow past a new clip is steady
constexpr double kReached = 3 * kBipolarTakes;  // m: the heat of forceps reaches no farther

double flowNow(const BleedingEnd& end, const std::vector<BleedingEnd>& now) {
  const auto same = std::ranges::find_if(now, [&](const BleedingEnd& other) {
    return other.organ == end.organ && other.segment == end.segment && other.end == end.end;
  });
  return same == now.end() ? 0 : same->flow;
}

bool isClosed(const BleedingEnd& end, const std::vector<BleedingEnd>& now) {
  return std::abs(flowNow(end, now)) <= kStopped * std::abs(end.flow);
}

// The end whose flow has fallen most; null: none has fallen by more than kNothing. closed: only
// ends that are closed now.
const BleedingEnd* mostStopped(const std::vector<BleedingEnd>& before,
                               const std::vector<BleedingEnd>& now, bool closed) {
  const BleedingEnd* best = nullptr;
  double most = kNothing;
  for (const BleedingEnd& end : before) {
    const double fallen = std::abs(end.flow) - std::abs(flowNow(end, now));
    if (fallen > most && (!closed || isClosed(end, now))) most = fallen, best = &end;
  }
  return best;
}

// A clip that was not there before; null: none. Both lists are sorted in the same way.
const ClippedVessel* newClip(const std::vector<ClippedVessel>& before,
                             const std::vector<ClippedVessel>& now) {
  for (std::size_t i = 0; i < now.size(); ++i)
    if (i >= before.size() || now[i] != before[i]) return &now[i];
  return nullptr;
}

QString millilitres(double perMinute) {
  return QString::number(perMinute, 'f', perMinute < 10 ? 1 : 0);
}

// "hepatic vein of segment III of 3.1 mm bled 20 ml/min, and 4.0 now". left: its flow now, m^3/s.
QString whatBled(const BleedingEnd& end, double left, const std::string& name) {
  const double flow = 60e6 * end.flow, still = 60e6 * left;  // ml/min
  const QString bled =
      flow < 0 ? Words::tr("drew in air")
      : still < 1
          ? Words::tr("bled %1 ml/min").arg(millilitres(flow))
          : Words::tr("bled %1 ml/min, and %2 now").arg(millilitres(flow), millilitres(still));
  return Words::tr("%1 of %2 mm %3")
      .arg(translated(name))
      .arg(2e3 * end.radius, 0, 'f', 1)
      .arg(bled);
}

}  // namespace

bool HaemostasisWatch::watches(const ToolModel& model) {
  return model.kind == "clip_applier" || model.kind == "bipolar";
}

HaemostasisWatch::HaemostasisWatch(int tool, const ToolModel& model)
    : tool_(tool), forceps_(model.kind == "bipolar"), tip_(model.tip) {}

QString HaemostasisWatch::follow(const LiveState& state, Worker worker, const NameOf& nameOf) {
  const auto tool = std::size_t(tool_);
  const bool known =
      worker != Worker::Nobody && tool < state.squeeze.size() && tool < state.poses.size();
  const double squeeze = known ? state.squeeze[tool] : 0;
  const bool closed = known && squeeze >= (forceps_ ? kBipolarCloses : kClipCloses);
  const bool same = worker == worker_;
  const bool shuts = closed && !closed_ && same;
  worker_ = worker;
  if (!known || state.time < placed_) placed_ = -1;  // put back, or an earlier moment is shown
  QString told;
  if (known && !forceps_) told = followClip(state, shuts, nameOf);
  if (closed && forceps_) told = followForceps(state, shuts, state.poses[tool] * tip_, nameOf);
  // A click may be too short for the jaws to close. Jaws that open after they were closed, or since
  // the instrument was taken, are no such click.
  if (!known || worker != Worker::Hand || !same || closed) {
    begun_ = {};
  } else if (squeeze < kBegun) {
    if (begun_ && *begun_ >= kBegun)
      told = Words::tr("The jaws did not close: hold the button down for half a second");
    begun_ = 0;
  } else if (begun_) {
    begun_ = squeeze;
  }
  closed_ = closed;
  if (!closed) opened_ = state.time;
  // What bled before a clip is kept until its effect is told, though the jaws are open again.
  if (!closed && placed_ < 0) clipsBefore_ = state.clips, endsBefore_ = state.bleedingEnds;
  return told;
}

QString HaemostasisWatch::followClip(const LiveState& state, bool shuts, const NameOf& nameOf) {
  // The moment in which the jaws are closed may be too short to be seen here.
  if (placed_ < 0 && state.clips.size() > clipsBefore_.size()) {
    placed_ = state.time;
  } else if (shuts && worker_ == Worker::Hand) {
    if (!state.bleeds) return Words::tr("No clip was placed: this organ has no vessels");
    return Words::tr(
               "No clip was placed: there is no open vessel within %1 mm of the jaws; point at "
               "a yellow ring, or change the depth with the wheel")
        .arg(1e3 * kClipReach, 0, 'f', 0);
  }
  if (placed_ < 0 || state.time < placed_ + kSteady) return {};
  placed_ = -1;
  if (const BleedingEnd* end = mostStopped(endsBefore_, state.bleedingEnds, false))
    return Words::tr("A clip was placed: the %1")
        .arg(whatBled(*end, flowNow(*end, state.bleedingEnds), nameOf(end->organ, end->segment)));
  const ClippedVessel* vessel = newClip(clipsBefore_, state.clips);
  if (!vessel) return {};  // it slipped
  return Words::tr("A clip was placed on the %1 of %2 mm, which did not bleed")
      .arg(translated(nameOf(vessel->organ, vessel->segment)))
      .arg(2e3 * vessel->radius, 0, 'f', 1);
}

// Told as soon as the vessel is sealed, while the forceps are still closed.
QString HaemostasisWatch::followForceps(const LiveState& state, bool shuts, const Vec3& tip,
                                        const NameOf& nameOf) {
  if (shuts)
    std::erase_if(endsBefore_,
                  [&](const BleedingEnd& end) { return (end.place - tip).norm() > kReached; });
  const BleedingEnd* end = mostStopped(endsBefore_, state.bleedingEnds, true);
  if (!end) return {};
  const QString told =
      Words::tr("Sealed: the %1").arg(whatBled(*end, 0, nameOf(end->organ, end->segment)));
  std::erase_if(endsBefore_,
                [&](const BleedingEnd& one) { return isClosed(one, state.bleedingEnds); });
  return told;
}

QString HaemostasisWatch::howLongClosed(const LiveState& state) const {
  if (!forceps_) return {};
  return Words::tr(", closed for %1 s of about 2")
      .arg(std::max(0.0, state.time - opened_), 0, 'f', 1);
}

}  // namespace resect
