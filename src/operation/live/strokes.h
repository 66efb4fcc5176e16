// Finds strokes. A stroke is a period in which instruments work on organs. Undo takes back one
// stroke.
//
// A stroke begins when an instrument in hand touches or cuts an organ. It ends when the hand lets
// go (FrameInput::strokeEnds), when no instrument has touched an organ for kEndSeconds, or when all
// instruments are put back. After the hand has let go, a tool takes part in a stroke again only
// when it is moved: a hook that was left holding does not.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "operation/live/operation_events.h"

namespace resect {

struct Stroke {
  std::int64_t from = 0, to = 0;  // frames: the last one before contact; the last one in contact
  std::int64_t tool = -1;         // the first tool that touched; -1: a blade cut without touching
  // So far: particles removed, bonds cut by instruments, bonds torn.
  std::int64_t removed = 0, severed = 0, torn = 0;
};

// Finds the strokes of one branch. The result depends on the inputs and events alone. So the
// strokes found in a recording are those that were found during the operation.
class StrokeTracker {
 public:
  // To be called after each step, with its events. frame: Simulation::frame() after the step.
  void add(std::int64_t frame, const FrameInput& input, std::span<const OperationEvent> events);
  const std::vector<Stroke>& strokes() const { return strokes_; }
  bool inStroke() const { return inStroke_; }  // the last stroke goes on

  static constexpr double kEndSeconds = 1;
  static constexpr double kMoves = 0.008;  // m: a tool that moves less still rests

 private:
  std::vector<Stroke> strokes_;
  EventMemory memory_;
  // Per tool: what it did when the hand let go, until it moves on. (A tool that is left at work may
  // still be on its last millimetre then.)
  std::vector<std::optional<ToolInput>> resting_;
  bool inStroke_ = false;
  double untouched_ = 0;  // s, since the last contact of the stroke
};

}  // namespace resect
