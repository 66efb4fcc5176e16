// An operation that runs in a thread of its own while a person looks at it.
//
// The thread steps the simulation at `frameRate` frames per second of real time. The window never
// waits for a frame, except in surface(). Inputs can be set at any moment and apply from the next
// frame on. take() gives surface changes as updates. Time lost by slow frames is not made up: the
// operation then runs slower than the clock, and StepTimes::realTimeFactor is below 1.
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

#include "operation/ledger/ledger_watch.h"
#include "operation/live/live_state.h"
#include "operation/live/operation_history.h"
#include "operation/live/surface_publisher.h"
#include "simulation/simulation.h"

namespace resect {

// Looks on, in the operation's thread, at what is new: branches that begin, and frames. What was
// done before and is shown again is not reported.
struct OperationWatch {
  std::function<void(const Branch&, const Simulation&)> began;
  std::function<void(const Branch&)> renamed;
  // Operating pauses: from this moment another one is shown, or the operation ends.
  std::function<void(Moment, const Simulation&)> stood;
  // events: of this frame; moment: its end.
  std::function<void(Moment moment, const FrameInput&, const StepReport&,
                     std::span<const OperationEvent> events, const Simulation&)>
      stepped;
};

class LiveOperation {
 public:
  // Gives the next frame of a motion; nothing at its end.
  using Motion = std::function<std::optional<FrameInput>()>;

  // Starts at once, with all tools out of hand at their rest poses (`rests`, one per tool).
  // frameRate: simulated frames per second, 1 to 1000. history: of an operation that was done
  // before, with `simulation` at history.now(); that moment is then shown until somebody goes on.
  // ledger: for LiveState::ledger.
  LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                double frameRate = 60, OperationWatch watch = {},
                std::optional<OperationHistory> history = {},
                std::optional<LedgerWatch> ledger = {});
  ~LiveOperation();  // stops the thread within the current frame
  LiveOperation(const LiveOperation&) = delete;
  LiveOperation& operator=(const LiveOperation&) = delete;

  // setTool() and setIso() take effect from the next frame on and may be called from any thread.
  // The jaws of a tool that is set here move no faster than a hand moves them (squeeze_speed.h).
  void setTool(int tool, const ToolInput& input);
  void setIso(float iso);
  // From the next frame on `motion` moves the tools. It is called once per frame, in the
  // operation's thread, until it returns nothing. play({}) ends it earlier. Of the FrameInput that
  // it returns, only `tools` is used. If a step refuses these tools, the motion ends too, and
  // LiveState::faults says why.
  void play(Motion motion);
  // The same after going back to the start of the operation, which is a request as below.
  std::int64_t playFromStart(Motion motion);
  bool playing() const;

  // Requests are numbered from 1 on and done in this order; each call returns its number. show()
  // replaces an earlier show() that is not done. LiveState::answered is the number of the last one
  // done. After it the moment is shown: all tools are where they were then, a motion has ended, and
  // nothing happens until goOn(). undo(), redo(): the moment before the last stroke; the one at
  // which undo() was called last. If there is none, nothing changes. show(): any moment of
  // LiveState::timeline.
  std::int64_t undo();
  std::int64_t redo();
  std::int64_t show(Moment moment);
  // While a moment is shown: plays what happened after it on the way to the end of `branch`. speed:
  // recorded seconds a second, 0 to 100; 0: stands.
  void setPlayback(double speed, std::int64_t branch);
  // Operates on from the moment that is shown: its branch goes on if it ends there, else another
  // one begins. Has no effect while a request is not done.
  void goOn();
  // What is done from the next frame on is another stroke.
  void endStroke();
  // Gives a branch of LiveState::timeline another name.
  void nameBranch(std::int64_t branch, const std::string& name);
  // Memory for the states of the history, bytes: 512 MB if it is not set.
  void setHistoryMemory(std::size_t most);
  void setPaused(bool paused);

  // Gives what is new since the last call of take(): writes one surface update per organ to
  // `updates`, and copies the state to `state`. If no frame has ended since that call, returns
  // false and changes neither.
  bool take(std::vector<SurfaceUpdate>& updates, LiveState& state);

  // The present surface of all organs, for saving. If a frame is being computed, or a request is
  // being answered, waits until that ends.
  SurfaceTracker::Compact surface();
  // Wait until at least this frame is done, or all requests are (for tests).
  void waitFor(std::int64_t frame);
  void waitForAnswer();

 private:
  struct Request {
    enum class Kind { Undo, Redo, Show };
    Kind kind = Kind::Undo;
    Moment moment;
    Motion motion;  // to be played then
    std::int64_t number = 0;
  };
  // What the thread is to do next; without names, request and playback: a frame of the operation.
  struct Task {
    std::optional<Request> request;
    std::vector<std::pair<std::int64_t, std::string>> names;  // for branches
    double playback = 0;       // the next frame of the history, at this speed
    std::int64_t towards = 0;  // on the way to the end of this branch
    bool operated = false;     // until now no moment was shown
    FrameInput input;
    bool byMotion = false;  // a motion gave the input's tools
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
  OperationHistory history_;           // used by the thread alone
  std::optional<LedgerWatch> ledger_;  // so are these
  const std::vector<Pose> rests_;
  LastSecond lastSecond_;
  StepReport report_;
  std::int64_t timelineFrame_ = 0;
  const OperationWatch watch_;
  const double frameRate_;
  const double wholeVolume_;  // m^3, before the operation
  mutable std::mutex mutex_;  // guards all members below; between frames, also simulation_
  std::condition_variable newFrame_, wake_;
  FrameInput input_;
  Motion motion_;
  // fresh_: a frame has ended since the last take().
  bool paused_ = false, ending_ = false, fresh_ = false;
  bool showing_ = false;
  double playback_ = 0;
  std::int64_t towards_ = 0;
  std::deque<Request> requests_;
  std::int64_t asked_ = 0;
  std::vector<std::pair<std::int64_t, std::string>> names_;  // that branches are to get
  std::optional<std::size_t> mostBytes_;                     // that the history is to take
  // A show() is being answered and has shown a state, so that a newer one may stop it.
  bool replaceable_ = false;
  bool motionComes_ = false;  // the request that is being answered brings one
  bool stepping_ = false;     // a frame is being computed: only the thread may use the simulation
  int readers_ = 0;  // callers waiting for the end of the frame; the next frame waits for them
  std::atomic<bool> stop_ = false;  // leaves the frame, or the way to a moment, being computed
  std::vector<SurfacePublisher> publishers_;  // one per organ
  LiveState state_;
  std::thread thread_;
};

}  // namespace resect
