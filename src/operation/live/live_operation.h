// How does an operation go on while a person looks at it?
//
// A thread of its own steps the simulation at the frame rate of real time; the window never waits
// for it. Inputs are handed in at any moment and used from the next frame on; what has changed is
// taken out in pieces the size of the change. Frames that the machine cannot do in time are not
// made up for: the operation then runs slower than the clock, and realTimeFactor says so.
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
  // Starts at once, with all tools out of hand where they lie (`rests`, one per tool). frameRate:
  // simulated frames per second, 1 to 1000.
  LiveOperation(std::unique_ptr<Simulation> simulation, const std::vector<Pose>& rests,
                double frameRate = 60);
  ~LiveOperation();  // ends the thread after the frame in work
  LiveOperation(const LiveOperation&) = delete;
  LiveOperation& operator=(const LiveOperation&) = delete;

  // From the next frame on. May be called from any thread. Jaws follow their squeeze as fast as a
  // hand closes them.
  void setTool(int tool, const ToolInput& input);
  void setIso(float iso);
  // From the next frame on the tools follow `motion`, which is asked once a frame, in the
  // operation's thread, until it gives nothing; an empty function ends it.
  void play(std::function<std::optional<FrameInput>()> motion);
  bool playing() const;
  void setPaused(bool paused);

  // Moves out what has changed since the last call and copies the state. False: no frame since.
  // updates: one per organ.
  bool take(std::vector<SurfaceUpdate>& updates, LiveState& state);

  // The surface where it is now, for saving; waits for the frame in work, and no longer.
  SurfaceTracker::Compact surface();
  // Waits until at least this frame has been done (for tests).
  void waitFor(std::int64_t frame);

 private:
  struct Frame {
    FrameInput input;
    std::vector<ToolInput> played;  // when a motion gave the input
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
  bool stepping_ = false;  // a frame is in work: the simulation is the thread's alone
  int readers_ = 0;        // who wait for the end of the frame; none begins before they are served
  std::vector<SurfacePublisher> publishers_;  // one per organ
  LiveState state_;
  std::thread thread_;
};

}  // namespace resect
