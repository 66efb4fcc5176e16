// Takes strokes of an operation back, and does them again, exactly.
//
// A stroke begins when an instrument in hand first touches an organ. It ends when the mouse button
// is released (endStroke()), when no instrument has touched an organ for a second, or when all are
// put back. While an instrument is in hand and touches
// nothing, the state is saved every few frames. Taking a stroke back restores the last state before
// the contact and plays the frames between again, so the state is the same bit for bit.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

// Whether a tool in hand touched or cut an organ in the step of this report.
bool touches(const StepReport& report);

class StrokeHistory {
 public:
  // mostBytes: memory for states; the oldest strokes are forgotten beyond it.
  explicit StrokeHistory(std::size_t mostBytes = std::size_t(512) << 20) : mostBytes_(mostBytes) {}

  // Call before and after each step.
  void beforeStep(const FrameInput& input, const Simulation& simulation);
  void afterStep(const FrameInput& input, const StepReport& report);

  // The stroke has ended. A new one begins when a tool that touches an organ is moved.
  void endStroke() {
    stroke_ = false;
    resting_ = true;
  }

  int undoable() const { return int(strokes_.size()); }  // strokes that can be taken back
  int redoable() const { return int(undone_.size()); }   // strokes that can be done again
  std::size_t bytes() const { return bytes_; }

  // Goes back to the end of the frame before the last stroke's first contact. False, and nothing
  // changes, if there is no stroke. At most kFramesBetween frames are played again.
  bool undo(Simulation& simulation);
  // Goes to where the last undo() began. False, and nothing changes, if there was none or a stroke
  // was made since.
  bool redo(Simulation& simulation);

  static constexpr int kFramesBetween = 6;  // most frames between two states before a contact
  static constexpr double kEndSeconds = 1;  // without contact: the stroke has ended

 private:
  // A moment of the operation: a state, and the inputs that lead from there to it.
  struct Moment {
    Bytes state;
    std::vector<FrameInput> inputs;
  };
  struct Undone {
    Moment before;  // the stroke
    Bytes after;    // the state in which undo() was called
  };
  static void goTo(const Moment& moment, Simulation& simulation);
  void
  forgetOldest();  // of the strokes that can be taken back, then of those that can be done again

  std::size_t mostBytes_, bytes_ = 0;
  Moment approach_;  // while no stroke is made; without a state if no tool is in hand
  bool stroke_ = false;
  bool resting_ = false;           // after endStroke(): no tool has moved yet
  std::vector<ToolInput> before_;  // tools of the last frame
  double untouched_ = 0;           // s, since the last contact of the stroke
  std::deque<Moment> strokes_;
  std::vector<Undone> undone_;
};

}  // namespace resect
