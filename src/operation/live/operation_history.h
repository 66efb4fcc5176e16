// All that has happened in an operation, so that any moment of it can be shown again, bit for bit.
//
// The history keeps the inputs of every frame of every branch, and states from which to play. A
// moment is reached from the last state before it by playing the inputs between. One state is kept
// a second, one at the start of each branch, and one at most kFramesBetween frames before each
// stroke. If the states need more memory than allowed, they thin out: the one whose removal leaves
// the shortest gap goes first, those of the present branch's last minute go last.
//
// Going to a moment and working on from there begins a new branch, unless the moment is the end of
// its branch, which then goes on. Undo and redo are ways to choose the moment.
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
  // One branch, as kept.
  struct Course {
    Branch branch;
    // Of the frames branch.from + 1, + 2, ...; equal inputs that follow each other are one object.
    std::vector<std::shared_ptr<const FrameInput>> inputs;
    std::map<std::int64_t, Bytes> states;  // by frame; the first is that of branch.from
    StrokeTracker strokes;
    EventMemory events;
    std::vector<std::int64_t> faults;  // frames
    // At its end: tissue removed, m^3; number and volume of the pieces, m^3; area of cuts, and of
    // faces that removed tissue has bared, m^2. removedVolume is of each frame, the others of the
    // last ledger.
    double removedVolume = 0, piecesVolume = 0, cut = 0, bared = 0;
    std::int64_t pieces = 0;
    // Largest force on each tool so far, N, a row per change: frame and one force per tool.
    std::vector<std::pair<std::int64_t, std::vector<double>>> peaks;

    std::int64_t end() const { return branch.from + std::int64_t(inputs.size()); }
    // The row of `peaks` that holds at that frame; empty: no force was kept until then.
    std::vector<double> peaksAt(std::int64_t frame) const;
    // The next frame, as it was: its input, its events and the force on each tool, N.
    void add(const FrameInput& input, std::span<const OperationEvent> frameEvents,
             std::span<const double> forces);
  };

  // simulation: at its start. frameRate: frames a second. mostBytes: for the states.
  OperationHistory(const Simulation& simulation, double frameRate,
                   std::size_t mostBytes = std::size_t(512) << 20);
  // Of a recording. courses: numbered from 0 on, each with its first state.
  OperationHistory(std::vector<Course> courses, double frameRate, Moment now,
                   std::size_t mostBytes = std::size_t(512) << 20);

  // Call before each step of the operation. Returns a branch that begins here, if one does.
  std::optional<Branch> beforeStep(const FrameInput& input, const Simulation& simulation);
  // Call after it. Returns the step's events.
  std::vector<OperationEvent> afterStep(const FrameInput& input, const StepReport& report,
                                        const Simulation& simulation);

  const std::vector<Course>& courses() const { return courses_; }
  Moment now() const { return now_; }
  bool atEnd() const { return now_.frame == courses_[std::size_t(now_.branch)].end(); }
  std::size_t bytes() const { return bytes_; }  // of the states
  void setMostBytes(std::size_t most);
  void rename(std::int64_t branch, std::string name);
  // The ledger of now(), which is the end of its branch.
  void note(const Ledger& ledger);
  // Largest force on each tool up to now, N.
  std::vector<double> peaks() const { return present().peaksAt(now_.frame); }

  // Where the last stroke begins that has led to now(); where the last undo was called. Nothing if
  // there is no such stroke or undo. Any stroke that is made ends what redo could do.
  std::optional<Moment> undoMoment() const;
  std::optional<Moment> redoMoment() const;
  int undoable() const;  // strokes that have led to now()
  int redoable() const { return int(undone_.size()); }
  // To be called with the moment of undoMoment() or redoMoment() when it has been reached.
  void undone(Moment from) { undone_.push_back(from); }
  void redone() { undone_.pop_back(); }

  // Called while goTo() plays, after the first state and after each frame.
  using Shown = std::function<void()>;
  // Leaves the simulation at the end of that frame. Throws Error if there is no such moment, and
  // Cancelled if stopped (base/stop.h): then call goTo() again, since the simulation is half
  // changed.
  void goTo(Moment moment, Simulation& simulation, const Shown& shown = {});
  // Whether goTo() or playNext() was stopped or failed on its way: the simulation is then in no
  // moment. mend() brings it back to now(); does nothing else.
  bool broken() const { return broken_; }
  void mend(Simulation& simulation) {
    if (broken_) goTo(now_, simulation);
  }
  // Plays the next frame on the way to the end of branch `towards` as it was. False at its end, or
  // if now() is not on that way: nothing is done.
  bool playNext(Simulation& simulation, StepReport& report, std::int64_t towards);

  static constexpr int kFramesBetween = 6;  // most frames between a state and a stroke
  static constexpr double kProtectedSeconds = 60;

 private:
  Course& present() { return courses_[std::size_t(now_.branch)]; }
  const Course& present() const { return courses_[std::size_t(now_.branch)]; }
  void keep(Course& course, std::int64_t frame, Bytes state);
  void drop(Course& course, std::int64_t frame);
  void thinOut();
  // For each branch that led to now(), the latest first: the branch and its last frame of the way.
  template <typename Visit>
  void walkBack(const Visit& visit) const;

  std::vector<Course> courses_;
  double frameRate_;
  std::size_t mostBytes_, bytes_ = 0;
  Moment now_;
  bool broken_ = false;                   // goTo() was stopped
  std::optional<std::int64_t> approach_;  // frame of a state kept in case that a stroke begins
  std::int64_t regular_ = 0;              // frame of the last state that was kept by the clock
  std::vector<Moment> undone_;
};

}  // namespace resect
