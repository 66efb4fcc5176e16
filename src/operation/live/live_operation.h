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
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "operation/live/live_state.h"
#include "operation/live/stroke_history.h"
#include "operation/live/surface_publisher.h"
#include "simulation/simulation.h"

namespace resect {

// Looks on, in the operation's thread: at each step, and at each undo and redo, which leave the
// simulation in another state.
struct OperationWatch {
  std::function<void(const FrameInput&, const StepReport&, const Simulation&)> stepped;
  std::function<void(bool undone, const Simulation&)> jumped;  // undone: false after a redo
};

class LiveOperation {
 public:
  // Starts at once, with all tools out of hand at their rest poses (`rests`, one per tool).
  // frameRate: simulated frames per second, 1 to 1000.
  LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                double frameRate = 60, OperationWatch watch = {});
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
  void play(std::function<std::optional<FrameInput>()> motion);
  bool playing() const;
  // Before the next frame, takes the last stroke back, or does the stroke again that was taken back
  // last (operation/live/stroke_history.h). All tools are then where they were in that state, and a
  // motion ends. LiveState::jumps counts these calls, also those that changed nothing.
  void undo();
  void redo();
  // What is done from the next frame on is another stroke.
  void endStroke();
  void setPaused(bool paused);

  // Gives what is new since the last call of take(): writes one surface update per organ to
  // `updates`, and copies the state to `state`. If no frame has ended since that call, returns
  // false and changes neither.
  bool take(std::vector<SurfaceUpdate>& updates, LiveState& state);

  // The present surface of all organs, for saving. If a frame is being computed, waits until that
  // frame ends.
  SurfaceTracker::Compact surface();
  // Waits until at least this frame is done (for tests).
  void waitFor(std::int64_t frame);

 private:
  enum class Jump { None, Undo, Redo };
  struct Frame {
    FrameInput input;
    std::vector<ToolInput> played;  // the tools as motion_ moves them; empty: no motion plays
    Jump jump = Jump::None;
    bool strokeEnds = false;
  };
  void work();
  void ask(Jump jump);
  void jump(Jump jump, FrameInput& input);
  std::optional<Frame> nextFrame(std::chrono::steady_clock::time_point due);

  std::unique_ptr<Simulation> simulation_;
  StrokeHistory history_;  // used by the thread alone
  const OperationWatch watch_;
  const double frameRate_;
  const double wholeVolume_;  // m^3, before the operation
  mutable std::mutex mutex_;  // guards all members below; between frames, also simulation_
  std::condition_variable newFrame_, wake_;
  FrameInput input_;
  std::function<std::optional<FrameInput>()> motion_;
  // fresh_: a frame has ended since the last take().
  bool paused_ = false, ending_ = false, fresh_ = false;
  Jump jump_ = Jump::None;
  bool strokeEnds_ = false;
  bool stepping_ = false;  // a frame is being computed: only the thread may use the simulation
  int readers_ = 0;  // callers waiting for the end of the frame; the next frame waits for them
  std::atomic<bool> stop_ = false;            // leaves the frame that is being computed
  std::vector<SurfacePublisher> publishers_;  // one per organ
  LiveState state_;
  std::thread thread_;
};

}  // namespace resect
