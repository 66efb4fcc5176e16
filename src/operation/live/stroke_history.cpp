#include "operation/live/stroke_history.h"

#include <algorithm>

namespace resect {

bool touches(const StepReport& report) {
  const auto cells = [](const ToolContacts& one) { return !one.cells.empty(); };
  const auto pushed = [](const Vec3& force) { return force.squaredNorm() > 0; };
  // A thin blade parts tissue between particles without pushing any.
  return report.removed > 0 || report.severed > 0 || std::ranges::any_of(report.contacts, cells) ||
         std::ranges::any_of(report.toolForce, pushed);
}

namespace {

bool still(const ToolInput& a, const ToolInput& b) {
  return a.pose.position == b.pose.position &&
         a.pose.rotation.coeffs() == b.pose.rotation.coeffs() && a.inHand == b.inHand &&
         a.squeeze == b.squeeze && a.pedal == b.pedal;
}

}  // namespace

void StrokeHistory::beforeStep(const FrameInput& input, const Simulation& simulation) {
  if (stroke_) return;
  const bool inHand = std::ranges::any_of(input.tools, &ToolInput::inHand);
  if (!inHand)
    approach_ = {};
  else if (approach_.state.empty() || int(approach_.inputs.size()) >= kFramesBetween)
    approach_ = {simulation.save(), {}};
}

void StrokeHistory::afterStep(const FrameInput& input, const StepReport& report) {
  if (!std::ranges::equal(input.tools, before_, still)) resting_ = false;
  before_ = input.tools;
  const bool contact = touches(report) && !resting_;
  if (contact) untouched_ = 0;
  if (stroke_) {
    untouched_ += input.duration;
    const bool inHand = std::ranges::any_of(input.tools, &ToolInput::inHand);
    if (!inHand || untouched_ > kEndSeconds) stroke_ = false;
  } else if (contact && !approach_.state.empty()) {
    stroke_ = true;
    for (const Undone& one : undone_) bytes_ -= one.before.state.size() + one.after.size();
    undone_.clear();
    bytes_ += approach_.state.size();
    strokes_.push_back(std::move(approach_));
    approach_ = {};
    forgetOldest();
  } else if (!approach_.state.empty()) {
    approach_.inputs.push_back(input);
  }
}

void StrokeHistory::forgetOldest() {
  while (bytes_ > mostBytes_ && strokes_.size() + undone_.size() > 1) {
    if (!strokes_.empty()) {
      bytes_ -= strokes_.front().state.size();
      strokes_.pop_front();
    } else {
      bytes_ -= undone_.front().before.state.size() + undone_.front().after.size();
      undone_.erase(undone_.begin());
    }
  }
}

void StrokeHistory::goTo(const Moment& moment, Simulation& simulation) {
  simulation.restore(moment.state);
  for (const FrameInput& input : moment.inputs) simulation.step(input);
}

bool StrokeHistory::undo(Simulation& simulation) {
  if (strokes_.empty()) return false;
  Undone one{std::move(strokes_.back()), simulation.save()};
  strokes_.pop_back();
  bytes_ += one.after.size();
  goTo(one.before, simulation);
  undone_.push_back(std::move(one));
  stroke_ = false;
  approach_ = {};
  forgetOldest();
  return true;
}

bool StrokeHistory::redo(Simulation& simulation) {
  if (undone_.empty()) return false;
  Undone one = std::move(undone_.back());
  undone_.pop_back();
  bytes_ -= one.after.size();
  simulation.restore(one.after);
  strokes_.push_back(std::move(one.before));
  stroke_ = false;
  approach_ = {};
  return true;
}

}  // namespace resect
