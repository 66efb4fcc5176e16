// An operation that runs in a thread of its own while a window shows it.
//
// The thread steps the simulation at `frameRate` frames per second of real time. The caller never
// waits for a frame, except in surface(), look() and the functions for tests. Inputs can be set at
// any moment. They take effect from the next frame on. take() gives the changes of the surfaces
// since the last call of take(). Time lost by slow frames is not made up: while frames are slow,
// the operation runs slower than the clock, and StepTimes::realTimeFactor is below 1.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "operation/adnexa/adnexa.h"
#include "operation/ledger/ledger_watch.h"
#include "operation/live/hand_speed.h"
#include "operation/live/live_state.h"
#include "operation/live/operation_history.h"
#include "operation/live/sight.h"
#include "operation/live/surface_publisher.h"
#include "simulation/simulation.h"

namespace resect {

// Functions that the operation's thread calls when something new happens. When frames of the
// history are played again, the functions are not called.
struct OperationWatch {
  std::function<void(const Branch&, const Simulation&)> began;
  std::function<void(const Branch&)> renamed;
  // The operation ends, or stops at the end of a branch in order to show another moment. The
  // function gets the end of the branch.
  std::function<void(Moment, const Simulation&)> stood;
  // moment: the end of the frame. events: the events of the frame.
  std::function<void(Moment moment, const FrameInput&, const StepReport&,
                     std::span<const OperationEvent> events, const Simulation&)>
      stepped;
};

class LiveOperation {
 public:
  // Returns the input of the motion's next frame; nothing at the motion's end.
  using Motion = std::function<std::optional<FrameInput>()>;

  // Starts at once. No tool is in hand; all are at their rest poses (`rests`, one per tool).
  // frameRate: simulated frames per second, 1 to 1000. history: the history of an operation that is
  // to be continued; `simulation` must be at history.now(). The operation then shows this moment
  // until goOn() is called. ledger: computes LiveState::ledger. Without `ledger`, LiveState::ledger
  // stays null. paused: whether the operation is paused (setPaused()) before its first frame.
  LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                double frameRate = 60, OperationWatch watch = {},
                std::optional<OperationHistory> history = {},
                std::optional<LedgerWatch> ledger = {}, bool paused = false);
  ~LiveOperation();  // stops the thread within the current frame
  LiveOperation(const LiveOperation&) = delete;
  LiveOperation& operator=(const LiveOperation&) = delete;

  // setTool(), setIso() and setBreathing() take effect from the next frame on and may be called
  // from any thread. setTool(): the jaws of the tool move no faster than a hand moves them
  // (hand_speed.h). motion: if given, the tool moves to the pose of `input` over several frames, as
  // a hand would move it. Otherwise the tool has this pose at the end of the next frame.
  // LiveState::poses has the present poses of the tools.
  void setTool(int tool, const ToolInput& input, std::optional<HandMotion> motion = {});
  void setIso(float iso);
  void setBreathing(bool on);  // as FrameInput::breathes
  // Sets whether the user sees the tips of the tools, one entry per tool. Takes effect from the
  // next frame on. Recordings keep these entries (sight.h).
  void setSight(std::vector<Sight> sight);
  // From the next frame on, `motion` moves the tools. `motion` is called once per frame, in the
  // operation's thread, until it returns nothing. play({}) ends the motion earlier. Of the
  // FrameInput that `motion` returns, only `tools` is used. If Simulation::step() throws because
  // `tools` is invalid, the motion ends too, and LiveState::faults says why.
  void play(Motion motion);
  // Goes back to the start of the operation, then does the same as play(). This is a request;
  // requests are explained below.
  std::int64_t playFromStart(Motion motion);
  bool playing() const;

  // undo(), redo(), show() and playFromStart() are requests. They are numbered from 1 on, and the
  // operation's thread does them in this order. Each call returns the number of its request.
  // LiveState::answered is the number of the last request done. A new show() replaces an earlier
  // show() that is not done yet.
  //
  // A request brings the operation to a moment of its history, which is then shown: all tools are
  // where they were at that moment, motions have ended, and no new frame begins until goOn() is
  // called. Only playFromStart() goes on by itself: it plays its motion from that moment on. undo()
  // goes to the moment before the last stroke (strokes.h). redo() goes to the moment at which the
  // last undo() was called. If there is nothing to undo or redo, nothing changes. show() goes to
  // any moment of LiveState::timeline.
  std::int64_t undo();
  std::int64_t redo();
  std::int64_t show(Moment moment);
  // While a moment is shown: plays the frames that lead from this moment to the end of `branch`.
  // speed: seconds of the operation per second of real time, 0 to 100; 0 stops the playback.
  void setPlayback(double speed, std::int64_t branch);
  // Operating goes on from the moment that is shown. If the moment is the end of its branch, this
  // branch goes on; otherwise a new branch begins. Has no effect before all requests are done.
  void goOn();
  // Ends the present stroke before the next frame.
  void endStroke();
  // Gives a branch of LiveState::timeline another name.
  void nameBranch(std::int64_t branch, const std::string& name);
  // Sets the largest memory for the states of the history, bytes. The default is 512 MB.
  void setHistoryMemory(std::size_t most);
  void setPaused(bool paused);

  // Gives the changes since the last call of take(): writes one surface update per organ to
  // `updates`, and copies the state to `state`. If no frame has ended since the last call, returns
  // false and changes neither `updates` nor `state`.
  bool take(std::vector<SurfaceUpdate>& updates, LiveState& state);

  // The present surface of all organs, for saving. If a frame is being computed or a request is
  // being answered, waits for its end.
  SurfaceTracker::Compact surface();
  // Calls `read` with the simulation between two frames. Waits as surface() does. The next frame
  // begins only after `read` has returned.
  void look(const std::function<void(const Simulation&)>& read);
  // For tests: waitFor() waits until the frame with this number is done, waitForAnswer() until all
  // requests are done.
  void waitFor(std::int64_t frame);
  void waitForAnswer();

 private:
  struct Request {
    enum class Kind { Undo, Redo, Show };
    Kind kind = Kind::Undo;
    Moment moment;
    Motion motion;  // to be played from `moment` on; empty: none
    std::int64_t number = 0;
  };
  // What the thread does next. If names, request and playback are not set, the thread computes a
  // frame of the operation.
  struct Task {
    std::optional<Request> request;
    std::vector<std::pair<std::int64_t, std::string>> names;  // new names for branches
    double playback = 0;       // > 0: plays the next frame of the history, at this speed
    std::int64_t towards = 0;  // number of the branch to whose end the playback leads
    bool operated = false;     // no moment of the history was shown before this task
    FrameInput input;
    std::vector<std::optional<HandMotion>> motions;  // as setTool() got them
    std::vector<Sight> sight;
    bool byMotion = false;  // a motion gave input.tools
  };
  std::int64_t ask(Request request);
  void work();
  std::optional<Task> nextTask(std::chrono::steady_clock::time_point due);
  void answer(Request request);
  void playBack(std::int64_t towards);
  void stand();
  void keepLedger(const Ledger* ledger);
  void operate(Task task);
  void publishMoment(Moment moment);
  void noteHistory();
  void nameBranches(const std::vector<std::pair<std::int64_t, std::string>>& names);
  std::vector<ToolInput> presentTools() const;

  std::unique_ptr<Simulation> simulation_;
  // Only the operation's thread uses the members from here to timelineFrame_.
  OperationHistory history_;
  std::optional<LedgerWatch> ledger_;
  std::vector<Sight> sightSaid_;  // memory for sightEvents()
  const std::vector<Pose> rests_;
  LastSecond lastSecond_;
  StepReport report_;
  std::int64_t timelineFrame_ = 0;
  const OperationWatch watch_;
  const double frameRate_;
  const double wholeVolume_;  // volume of the tissue before the operation, m^3
  mutable std::mutex mutex_;  // guards all members below; between frames, also simulation_
  std::condition_variable newFrame_, wake_;
  FrameInput input_;
  std::vector<std::optional<HandMotion>> motions_;  // one per tool, as setTool() got it
  // One per tool: HandMotion::from in the last frame. Used by the thread only.
  std::vector<std::optional<Pose>> pressedFrom_;
  std::vector<Sight> sight_;  // as setSight() got it
  Motion motion_;
  // fresh_: a frame has ended since the last take().
  bool paused_ = false, ending_ = false, fresh_ = false;
  bool showing_ = false;
  double playback_ = 0;
  std::int64_t towards_ = 0;
  std::deque<Request> requests_;
  std::int64_t asked_ = 0;
  std::vector<std::pair<std::int64_t, std::string>> names_;  // new names for branches
  std::optional<std::size_t> mostBytes_;                     // new limit for the history
  // A show() is being answered and has shown at least one state. A newer show() may now stop it.
  bool replaceable_ = false;
  bool motionComes_ = false;  // the request that is being answered has a motion
  bool stepping_ = false;     // a frame is being computed: only the thread may use simulation_
  // Number of callers that wait for the end of the frame. The next frame waits for these callers.
  int readers_ = 0;
  // Set to true in order to stop a computation: of the present frame, or of the frames that lead to
  // a moment.
  std::atomic<bool> stop_ = false;
  std::vector<SurfacePublisher> publishers_;  // one per organ
  Adnexa adnexa_;
  LiveState state_;
  std::thread thread_;
};

}  // namespace resect
