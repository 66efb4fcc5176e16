// Keeps everything that has happened in an operation, so that any of its moments can be shown
// again, bit for bit.
//
// The history keeps the inputs of every frame of every branch, and some states. To reach a moment,
// the last state before this moment is restored, and the inputs after this state are played. One
// state is kept per second, one at the start of each branch, and one at most kFramesBetween frames
// before each stroke. A stroke is a period in which instruments work on organs (strokes.h). If the
// states need more memory than allowed, some are dropped. The first to be dropped is the state
// whose removal leaves the shortest gap. States of the present branch's last minute are dropped
// last.
//
// If the user goes back to an earlier moment and operates from there, a new branch begins. But if
// this moment is the end of its branch, no new branch begins: the old branch goes on. Undo and redo
// are two ways to choose the moment to which the user goes.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "operation/ledger/ledger.h"
#include "operation/live/branch.h"
#include "operation/live/strokes.h"
#include "simulation/simulation.h"

namespace resect {

class OperationHistory {
 public:
  // The data that are kept for one branch.
  struct Course {
    Branch branch;
    // The inputs of the frames branch.from + 1, branch.from + 2, ... Consecutive equal inputs share
    // one object.
    std::vector<std::shared_ptr<const FrameInput>> inputs;
    std::map<std::int64_t, Bytes> states;  // by frame; the first one is at branch.from
    StrokeTracker strokes;
    EventMemory events;
    std::vector<std::int64_t> faults;  // frames in which faults occurred
    // At the end of the branch: volume of removed tissue and of the pieces, m^3; areas of cuts and
    // of bared faces, m^2; number of pieces. removedVolume is updated in each frame, the other
    // values when a ledger is computed.
    double removedVolume = 0, piecesVolume = 0, cut = 0, bared = 0;
    std::int64_t pieces = 0;
    // Largest force on each tool so far, N. There is a row for each frame in which one of these
    // forces grew. A row has the frame's number and one force per tool.
    std::vector<std::pair<std::int64_t, std::vector<double>>> peaks;

    std::int64_t end() const { return branch.from + std::int64_t(inputs.size()); }
    // The forces in the last row of `peaks` whose frame is not after `frame`; empty if there is no
    // such row.
    std::vector<double> peaksAt(std::int64_t frame) const;
    // Adds the next frame: its input, its events, and the force on each tool, N.
    void add(const FrameInput& input, std::span<const OperationEvent> frameEvents,
             std::span<const double> forces);
  };

  // simulation: at the start of its operation. frameRate: frames per second. mostBytes: largest
  // memory for the states.
  OperationHistory(const Simulation& simulation, double frameRate,
                   std::size_t mostBytes = std::size_t(512) << 20);
  // The history that a recording holds. courses: one per branch, in the order of the branches'
  // numbers; each has the state at its start. now: the present moment.
  OperationHistory(std::vector<Course> courses, double frameRate, Moment now,
                   std::size_t mostBytes = std::size_t(512) << 20);

  // Call before each step of the operation. If a new branch begins with this step, returns the
  // branch.
  std::optional<Branch> beforeStep(const FrameInput& input, const Simulation& simulation);
  // Call after each step of the operation. Returns the step's events.
  std::vector<OperationEvent> afterStep(const FrameInput& input, const StepReport& report,
                                        const Simulation& simulation);

  const std::vector<Course>& courses() const { return courses_; }
  Moment now() const { return now_; }
  bool atEnd() const { return now_.frame == courses_[std::size_t(now_.branch)].end(); }
  std::size_t bytes() const { return bytes_; }  // memory of the states
  void setMostBytes(std::size_t most);
  void rename(std::int64_t branch, std::string name);
  // Copies the areas of cuts and bared faces and the number and volume of pieces from a ledger to
  // the present branch. The ledger must be that of now(), and now() must be the end of the branch.
  void note(const Ledger& ledger);
  // Largest force on each tool up to now, N.
  std::vector<double> peaks() const { return present().peaksAt(now_.frame); }

  // undoMoment(): the moment before the last stroke that has led to now(). redoMoment(): the moment
  // at which the last undo was called. Both return nothing if there is no such stroke or undo. When
  // a new stroke begins, nothing can be redone any more.
  std::optional<Moment> undoMoment() const;
  std::optional<Moment> redoMoment() const;
  int undoable() const;  // number of strokes that have led to now()
  int redoable() const { return int(undone_.size()); }
  // Call undone() when undoMoment() was reached; `from` is the moment at which undo was called.
  // Call redone() when redoMoment() was reached.
  void undone(Moment from) { undone_.push_back(from); }
  void redone() { undone_.pop_back(); }

  // Called while goTo() plays, after a state was restored and after each frame.
  using Shown = std::function<void()>;
  // Brings the simulation to `moment`. Throws Error if there is no such moment. Throws Cancelled
  // if a stop was requested (base/stop.h). After Cancelled the simulation is not at any moment of
  // the history; call goTo() or mend() before anything else.
  void goTo(Moment moment, Simulation& simulation, const Shown& shown = {});
  // Whether goTo() or playNext() was stopped or failed, so that the simulation is not at any moment
  // of the history. If broken(), mend() brings the simulation back to now(). If not, mend() does
  // nothing.
  bool broken() const { return broken_; }
  void mend(Simulation& simulation) {
    if (broken_) goTo(now_, simulation);
  }
  // Plays the next recorded frame on the way to the end of branch `towards`
  // (operation/live/timeline.h). Does nothing and returns false at that end, or if now() is not on
  // that way.
  bool playNext(Simulation& simulation, StepReport& report, std::int64_t towards);

  static constexpr int kFramesBetween = 6;  // greatest number of frames from a state to a stroke
  static constexpr double kProtectedSeconds = 60;

 private:
  Course& present() { return courses_[std::size_t(now_.branch)]; }
  const Course& present() const { return courses_[std::size_t(now_.branch)]; }
  void keep(Course& course, std::int64_t frame, Bytes state);
  void drop(Course& course, std::int64_t frame);
  void thinOut();
  // Calls visit() for each branch that led to now(), the latest branch first. visit() gets the
  // branch's course and the number of the last frame of this course that led to now().
  template <typename Visit>
  void walkBack(const Visit& visit) const;

  std::vector<Course> courses_;
  double frameRate_;
  std::size_t mostBytes_, bytes_ = 0;
  Moment now_;
  bool broken_ = false;                   // see broken()
  std::optional<std::int64_t> approach_;  // frame of a state kept in case a stroke begins
  std::int64_t regular_ = 0;  // frame of the last state that was kept because a second had passed
  std::vector<Moment> undone_;
};

}  // namespace resect
