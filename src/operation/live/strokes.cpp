#include "operation/live/strokes.h"

#include <algorithm>

namespace resect {
namespace {

constexpr double kStill = 1e-4;  // m in a frame

// Whether a tool that did `a` when the hand let go still rests when it does `b`.
bool rests(const ToolInput& a, const ToolInput& b) {
  constexpr double kTurns = 0.05;  // rad
  return (a.pose.position - b.pose.position).norm() < StrokeTracker::kMoves &&
         angleBetween(a.pose.rotation, b.pose.rotation) < kTurns && a.inHand == b.inHand &&
         a.squeeze == b.squeeze && a.pedal == b.pedal;
}

}  // namespace

void StrokeTracker::add(std::int64_t frame, const FrameInput& input,
                        std::span<const OperationEvent> events) {
  const std::size_t tools = input.tools.size();
  resting_.resize(tools);
  if (input.strokeEnds) inStroke_ = false, left_ = 0;
  bool works = false;  // a tool that is in hand and does not rest
  for (std::size_t i = 0; i < tools; ++i) {
    std::optional<Resting>& resting = resting_[i];
    if (input.strokeEnds) resting = {input.tools[i], true};
    if (resting && resting->lags) {
      const bool touches = i < memory_.touching.size() && memory_.touching[i];
      const double way = (input.tools[i].pose.position - resting->input.pose.position).norm();
      if (touches) resting->input.pose = input.tools[i].pose;
      resting->lags = touches && left_ < kLags && (input.strokeEnds || way > kStill);
    }
    if (resting && !rests(resting->input, input.tools[i])) resting.reset();
    works |= input.tools[i].inHand && !resting;
  }
  left_ += input.duration;

  Stroke now{frame - 1, frame, -1, 0, 0, 0};
  for (const OperationEvent& event : events) {
    remember(memory_, event, tools);
    if (event.kind == "remove") now.removed += std::int64_t(event.amount);
    if (event.kind == "cut") now.severed += std::int64_t(event.amount);
    if (event.kind == "tear") now.torn += std::int64_t(event.amount);
  }
  bool touching = false;
  for (std::size_t i = std::min(tools, memory_.touching.size()); i-- > 0;)
    if (memory_.touching[i] && !resting_[i]) touching = true, now.tool = std::int64_t(i);
  // A thin blade parts tissue between particles without pushing any.
  const bool contact = touching || (works && (now.removed > 0 || now.severed > 0));

  if (contact && !inStroke_) {
    strokes_.push_back(now);
    inStroke_ = true;
  } else if (inStroke_) {
    Stroke& stroke = strokes_.back();
    if (stroke.tool < 0) stroke.tool = now.tool;
    stroke.removed += now.removed, stroke.severed += now.severed, stroke.torn += now.torn;
    if (contact) stroke.to = frame;
  }
  untouched_ = contact ? 0 : untouched_ + input.duration;
  if (!std::ranges::any_of(input.tools, &ToolInput::inHand) || untouched_ > kEndSeconds)
    inStroke_ = false;
}

}  // namespace resect
