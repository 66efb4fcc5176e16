#include "operation/live/strokes.h"

#include <algorithm>

namespace resect {
namespace {

bool still(const ToolInput& a, const ToolInput& b) {
  return a.pose.position == b.pose.position &&
         a.pose.rotation.coeffs() == b.pose.rotation.coeffs() && a.inHand == b.inHand &&
         a.squeeze == b.squeeze && a.pedal == b.pedal;
}

}  // namespace

void StrokeTracker::add(std::int64_t frame, const FrameInput& input,
                        std::span<const OperationEvent> events) {
  if (input.strokeEnds) inStroke_ = false, resting_ = true;
  if (!std::ranges::equal(input.tools, before_, still)) resting_ = false;
  before_ = input.tools;

  Stroke now{frame - 1, frame, -1, 0, 0, 0};
  for (const OperationEvent& event : events) {
    remember(memory_, event, input.tools.size());
    if (event.kind == "remove") now.removed += std::int64_t(event.amount);
    if (event.kind == "cut") now.severed += std::int64_t(event.amount);
    if (event.kind == "tear") now.torn += std::int64_t(event.amount);
  }
  const auto touching = std::ranges::find(memory_.touching, char(1));
  // A thin blade parts tissue between particles without pushing any.
  const bool contact =
      !resting_ && (touching != memory_.touching.end() || now.removed > 0 || now.severed > 0);
  if (touching != memory_.touching.end()) now.tool = touching - memory_.touching.begin();

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
