// An operation that runs in a thread of its own while a person looks at it.
//
// The thread steps the simulation at the frame rate of real time; the window never waits for it.
// Inputs can be set at any moment and apply from the next frame on; surface changes are taken as
// updates. Time lost by slow frames is not made up: the operation then runs slower than the clock,
// and StepTimes::realTimeFactor is below 1.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "operation/live/live_state.h"
#include "operation/live/surface_publisher.h"
#include "simulation/simulation.h"

namespace resect {

class LiveOperation {
 public:
  // Starts at once, with all tools out of hand at their rest poses (`rests`, one per tool).
  // frameRate: simulated frames per second, 1 to 1000.
  LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                double frameRate = 60);
  ~LiveOperation();  // ends the thread after the current frame
  LiveOperation(const LiveOperation&) = delete;
  LiveOperation& operator=(const LiveOperation&) = delete;

  // Takes effect from the next frame on. May be called from any thread. Jaws move no faster than a
  // hand moves them (squeeze_speed.h).
  void setTool(int tool, const ToolInput& input);
  void setIso(float iso);
  // From the next frame on `motion` moves the tools. It is called once per frame, in the
  // operation's thread, until it returns nothing; play({}) ends it earlier. Of its result only
  // `tools` is used. If a step refuses this input, the motion ends too, and LiveState::faults says
  // why.
  void play(std::function<std::optional<FrameInput>()> motion);
  bool playing() const;
  void setPaused(bool paused);

  // Moves the changes since the last call to `updates`, one per organ, and copies the state.
  // Returns false, and changes neither, if no frame has ended since.
  bool take(std::vector<SurfaceUpdate>& updates, LiveState& state);

  // The present surface, for saving. Waits at most until the current frame ends.
  SurfaceTracker::Compact surface();
  // Waits until at least this frame is done (for tests).
  void waitFor(std::int64_t frame);

 private:
  struct Frame {
    FrameInput input;
    std::vector<ToolInput> played;  // the tools as a motion moves them; empty: none does
  };
  void work();
  std::optional<Frame> nextFrame(std::chrono::steady_clock::time_point due);

  std::unique_ptr<Simulation> simulation_;
  const double frameRate_;
  const double wholeVolume_;  // m^3, before the operation
  mutable std::mutex mutex_;  // guards all below, and the simulation between frames
  std::condition_variable newFrame_, wake_;
  FrameInput input_;
  std::function<std::optional<FrameInput>()> motion_;
  bool paused_ = false, ending_ = false, fresh_ = false;
  bool stepping_ = false;  // a frame is being computed: only the thread may use the simulation
  int readers_ = 0;  // callers waiting for the end of the frame; the next frame waits for them
  std::vector<SurfacePublisher> publishers_;  // one per organ
  LiveState state_;
  std::thread thread_;
};

}  // namespace resect
