// Finds strokes. A stroke is a period in which instruments work on organs. Undo takes back one
// stroke.
//
// A stroke begins when an instrument in hand touches or cuts an organ. It ends when the hand lets
// go (FrameInput::strokeEnds), when no instrument has touched an organ for kEndSeconds, or when all
// instruments are put back. After the hand has let go, a tool takes part in strokes again only when
// it is moved. So a hook that was left holding tissue starts no stroke.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "operation/live/operation_events.h"

namespace resect {

struct Stroke {
  std::int64_t from = 0, to = 0;  // last frame before contact; last frame in contact
  std::int64_t tool = -1;         // number of the first tool that touched; -1: no tool touched
  // Numbers in this stroke so far: of particles removed, of bonds cut by instruments, and of bonds
  // torn.
  std::int64_t removed = 0, severed = 0, torn = 0;
};

// Finds the strokes of one branch. The result depends on the inputs and events alone. So the same
// strokes are found in a recording as during the operation.
class StrokeTracker {
 public:
  // To be called after each step, with its events. frame: Simulation::frame() after the step.
  void add(std::int64_t frame, const FrameInput& input, std::span<const OperationEvent> events);
  const std::vector<Stroke>& strokes() const { return strokes_; }
  bool inStroke() const { return inStroke_; }  // whether the last stroke has not ended yet

  static constexpr double kEndSeconds = 1;
  static constexpr double kMoves = 0.008;  // m: a tool that has moved less counts as not moved
  static constexpr double kLags = 0.3;     // s: the longest time that a tool lags behind the hand

 private:
  std::vector<Stroke> strokes_;
  EventMemory memory_;
  // A tool that the hand left. A tool that lags behind the hand first moves on to where the hand
  // left it; from the first frame in which it stands still, every movement is a new one.
  struct Resting {
    ToolInput input;
    bool lags = true;
  };
  std::vector<std::optional<Resting>> resting_;  // per tool; none after it was moved again
  bool inStroke_ = false;
  double untouched_ = 0;  // s, since the last contact of the stroke
  double left_ = 0;       // s, since the hand let go
};

}  // namespace resect
