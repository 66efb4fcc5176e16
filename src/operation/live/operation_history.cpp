#include "operation/live/operation_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "base/error.h"

namespace resect {
namespace {

bool same(const ToolInput& a, const ToolInput& b) {
  // Bits, since -0 and 0 may lead to other states.
  return std::memcmp(a.pose.position.data(), b.pose.position.data(), sizeof(Vec3)) == 0 &&
         std::memcmp(a.pose.rotation.coeffs().data(), b.pose.rotation.coeffs().data(),
                     4 * sizeof(double)) == 0 &&
         a.inHand == b.inHand && std::memcmp(&a.squeeze, &b.squeeze, sizeof(double)) == 0 &&
         std::memcmp(&a.pedal, &b.pedal, sizeof(double)) == 0;
}

bool same(const FrameInput& a, const FrameInput& b) {
  return a.duration == b.duration && a.iso == b.iso && a.strokeEnds == b.strokeEnds &&
         a.breathes == b.breathes && a.edits.empty() && b.edits.empty() &&
         std::ranges::equal(a.tools, b.tools,
                            [](const ToolInput& x, const ToolInput& y) { return same(x, y); });
}

std::string clockText(double seconds) {
  const auto whole = std::int64_t(seconds);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

OperationHistory::OperationHistory(const Simulation& simulation, double frameRate,
                                   std::size_t mostBytes)
    : frameRate_(frameRate),
      mostBytes_(mostBytes),
      now_{0, simulation.frame()},
      regular_(simulation.frame()) {
  Course first;
  first.branch = {0, -1, simulation.frame(), kFirstBranch};
  keep(first, simulation.frame(), simulation.save());
  courses_.push_back(std::move(first));
}

OperationHistory::OperationHistory(std::vector<Course> courses, double frameRate, Moment now,
                                   std::size_t mostBytes)
    : courses_(std::move(courses)),
      frameRate_(frameRate),
      mostBytes_(mostBytes),
      now_(now),
      regular_(now.frame) {
  for (const Course& course : courses_)
    for (const auto& [frame, state] : course.states) bytes_ += state.size();
  thinOut();
}

std::optional<Branch> OperationHistory::beforeStep(const FrameInput& input,
                                                   const Simulation& simulation) {
  std::optional<Branch> begun;
  if (!atEnd()) {
    const auto number = std::int64_t(courses_.size());
    Course course;
    course.branch = {number, now_.branch, now_.frame,
                     fmt::format("{}, from {}", number, clockText(simulation.time()))};
    course.peaks.emplace_back(now_.frame, peaks());
    for (const OperatedOrgan& o : simulation.organs())
      course.removedVolume += o.organ.removedVolume;
    keep(course, now_.frame, simulation.save());
    courses_.push_back(std::move(course));
    now_ = {number, now_.frame};
    regular_ = now_.frame;
    approach_.reset();
    begun = present().branch;
  }
  const std::int64_t frame = now_.frame;
  if (frame - regular_ >= std::llround(frameRate_)) {
    keep(present(), frame, simulation.save());
    regular_ = frame;
  }
  // While an instrument is in hand and touches nothing, a stroke may begin at any time.
  const bool inHand = std::ranges::any_of(input.tools, &ToolInput::inHand);
  const bool near = !present().states.empty() &&
                    frame - std::prev(present().states.upper_bound(frame))->first < kFramesBetween;
  if (inHand && !present().strokes.inStroke() && !near) {
    if (approach_) drop(present(), *approach_);
    keep(present(), frame, simulation.save());
    approach_ = frame;
  }
  return begun;
}

void OperationHistory::Course::add(const FrameInput& input,
                                   std::span<const OperationEvent> frameEvents,
                                   std::span<const double> forces) {
  if (!inputs.empty() && same(*inputs.back(), input))
    inputs.push_back(inputs.back());
  else
    inputs.push_back(std::make_shared<const FrameInput>(input));
  for (const OperationEvent& event : frameEvents)
    if (event.kind == "fault") faults.push_back(end());
  strokes.add(end(), input, frameEvents);

  std::vector<double> most = peaks.empty() ? std::vector<double>() : peaks.back().second;
  most.resize(forces.size(), 0);
  bool larger = peaks.empty();
  for (std::size_t t = 0; t < forces.size(); ++t)
    if (forces[t] > most[t]) most[t] = forces[t], larger = true;
  if (larger) peaks.emplace_back(end(), std::move(most));
}

std::vector<OperationEvent> OperationHistory::afterStep(const FrameInput& input,
                                                        const StepReport& report,
                                                        const Simulation& simulation) {
  Course& course = present();
  now_.frame = simulation.frame();
  std::vector<OperationEvent> events = eventsOf(report, simulation, course.events);
  for (OperationEvent& event : events) event.branch = now_.branch;
  std::vector<double> forces;
  for (const Vec3& force : report.toolForce) forces.push_back(force.norm());
  const std::size_t strokes = course.strokes.strokes().size();
  course.add(input, events, forces);
  course.removedVolume = 0;
  for (const OperatedOrgan& o : simulation.organs()) course.removedVolume += o.organ.removedVolume;
  if (course.strokes.strokes().size() > strokes) {
    approach_.reset();  // the state stays
    undone_.clear();
  }
  return events;
}

std::vector<double> OperationHistory::Course::peaksAt(std::int64_t frame) const {
  auto row = std::ranges::upper_bound(peaks, frame, {}, [](const auto& r) { return r.first; });
  return row == peaks.begin() ? std::vector<double>() : std::prev(row)->second;
}

template <typename Visit>
void OperationHistory::walkBack(const Visit& visit) const {
  std::int64_t last = now_.frame;
  for (std::int64_t b = now_.branch; b >= 0;) {
    const Course& course = courses_[std::size_t(b)];
    visit(course, last);
    last = std::min(last, course.branch.from);
    b = course.branch.parent;
  }
}

std::optional<Moment> OperationHistory::undoMoment() const {
  std::optional<Moment> moment;
  walkBack([&](const Course& course, std::int64_t last) {
    if (moment) return;
    const auto& strokes = course.strokes.strokes();
    const auto after = std::ranges::lower_bound(strokes, last, {}, &Stroke::from);
    if (after != strokes.begin()) moment = Moment{course.branch.number, std::prev(after)->from};
  });
  return moment;
}

void OperationHistory::setMostBytes(std::size_t most) {
  mostBytes_ = most;
  thinOut();
}

void OperationHistory::note(const Ledger& ledger) {
  Course& course = present();
  course.pieces = ledger.pieces();
  course.piecesVolume = ledger.tissue().pieces.volume;
  course.cut = ledger.cut();
  course.bared = ledger.bared();
}

void OperationHistory::rename(std::int64_t branch, std::string name) {
  if (branch < 0 || std::size_t(branch) >= courses_.size())
    throw error("the operation has no branch {}; choose another", branch);
  courses_[std::size_t(branch)].branch.name = std::move(name);
}

std::optional<Moment> OperationHistory::redoMoment() const {
  if (undone_.empty()) return std::nullopt;
  return undone_.back();
}

int OperationHistory::undoable() const {
  std::ptrdiff_t count = 0;
  walkBack([&](const Course& course, std::int64_t last) {
    const auto& strokes = course.strokes.strokes();
    count += std::ranges::lower_bound(strokes, last, {}, &Stroke::from) - strokes.begin();
  });
  return int(count);
}

void OperationHistory::goTo(Moment moment, Simulation& simulation, const Shown& shown) {
  if (moment.branch < 0 || std::size_t(moment.branch) >= courses_.size() ||
      moment.frame < courses_[std::size_t(moment.branch)].branch.from ||
      moment.frame > courses_[std::size_t(moment.branch)].end())
    throw error("the operation has no frame {} of branch {}; choose another", moment.frame,
                moment.branch);
  // So that the way back to where the work stopped is short.
  if (!broken_ && atEnd() && !(moment == now_) && !present().states.contains(now_.frame))
    keep(present(), now_.frame, simulation.save());
  const Course& course = courses_[std::size_t(moment.branch)];
  const auto state = std::prev(course.states.upper_bound(moment.frame));
  const bool onTheWay = !broken_ && moment.branch == now_.branch && now_.frame <= moment.frame &&
                        now_.frame >= state->first;
  broken_ = true;
  if (!onTheWay) {
    simulation.restore(state->second);
    if (shown) shown();
  }
  StepReport report;
  for (std::int64_t frame = simulation.frame(); frame < moment.frame; ++frame) {
    simulation.step(*course.inputs[std::size_t(frame - course.branch.from)], report);
    if (shown) shown();
  }
  broken_ = false;
  now_ = moment;
  regular_ = state->first;
  approach_.reset();
}

bool OperationHistory::playNext(Simulation& simulation, StepReport& report, std::int64_t towards) {
  // The first state of a branch is its parent's; from there into the branch that the way takes.
  while (now_.branch != towards && present().branch.parent >= 0 &&
         now_.frame == present().branch.from)
    now_.branch = present().branch.parent;
  for (std::int64_t b = towards; b >= 0 && std::size_t(b) < courses_.size();) {
    const Branch& branch = courses_[std::size_t(b)].branch;
    if (b == now_.branch) break;
    if (branch.from <= now_.frame) {
      if (branch.from < now_.frame || branch.parent != now_.branch) return false;
      now_.branch = b;
      break;
    }
    b = branch.parent;
  }
  if (atEnd()) return false;
  const Course& course = present();
  broken_ = true;
  simulation.step(*course.inputs[std::size_t(now_.frame - course.branch.from)], report);
  broken_ = false;
  now_.frame = simulation.frame();
  return true;
}

void OperationHistory::keep(Course& course, std::int64_t frame, Bytes state) {
  const auto [at, isNew] = course.states.try_emplace(frame);
  if (!isNew) return;
  bytes_ += state.size();
  at->second = std::move(state);
  thinOut();
}

void OperationHistory::drop(Course& course, std::int64_t frame) {
  const auto at = course.states.find(frame);
  if (at == course.states.end() || frame == course.branch.from) return;
  bytes_ -= at->second.size();
  course.states.erase(at);
}

void OperationHistory::thinOut() {
  const auto young = now_.frame - std::llround(kProtectedSeconds * frameRate_);
  for (const bool alsoYoung : {false, true}) {
    while (bytes_ > mostBytes_) {
      Course* from = nullptr;
      std::int64_t which = 0, shortest = std::numeric_limits<std::int64_t>::max();
      for (Course& course : courses_)
        for (auto at = course.states.begin(); at != course.states.end(); ++at) {
          if (at == course.states.begin()) continue;
          if (!alsoYoung && course.branch.number == now_.branch && at->first > young) break;
          const auto after = std::next(at);
          const std::int64_t end = after == course.states.end() ? course.end() : after->first;
          const std::int64_t gap = end - std::prev(at)->first;
          if (gap < shortest) shortest = gap, which = at->first, from = &course;
        }
      if (!from) break;
      if (from->branch.number == now_.branch && approach_ == which) approach_.reset();
      drop(*from, which);
    }
  }
}

}  // namespace resect
