// How does an operation go on while a person looks at it?
//
// A thread of its own steps the simulation at the frame rate of real time; the window never waits
// for it. Inputs are handed in at any moment and used from the next frame on; what has changed is
// taken out in pieces the size of the change. Frames that the machine cannot do in time are not
// made up for: the operation then runs slower than the clock, and realTimeFactor says so.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

// Parts of the surface that differ from what was taken before; apply them in their order.
struct SurfaceUpdate {
  struct Vertices {
    int first = 0;
    std::vector<Vec3f> points, normals;  // world, m; unit, outwards
    std::vector<float> cut;
    std::vector<Vec3f> rest;  // where the tissue was at rest, m
  };
  struct Triangles {
    int first = 0;
    std::vector<Triangle> triangles;
  };
  bool everything = false;  // forget all vertices and triangles that there were
  std::vector<Vertices> vertices;
  std::vector<Triangles> triangles;

  bool empty() const { return !everything && vertices.empty() && triangles.empty(); }
};

// Where is the tip of a tool in hand, as seen by the tissue where it is now?
struct TipPlace {
  double below = 0;     // height (y, m) of the tissue or table top straight below the tip
  double distance = 0;  // m to the nearest vertex of the surface; 0 inside; at most kTipReach
};
constexpr double kTipReach = 0.03;

struct StageTime {
  std::string name;
  double median = 0;  // s, over the last second
};

// What panels show: the newest state.
struct LiveState {
  std::int64_t frame = 0;
  double time = 0;  // simulated, s
  // s of the steady clock: when a frame last took particles away.
  double lastRemoval = 0;
  std::int64_t particles = 0, removed = 0, triangles = 0;
  double removedVolume = 0, volume = 0;  // m^3
  float iso = 50;
  std::vector<TipPlace> tips;          // one per tool; meaningful for those in hand
  std::vector<double> squeeze;         // of each tool's jaws
  std::vector<ToolInput> played;       // what a motion made the tools do; empty: none did
  std::vector<std::uint8_t> touching;  // 1 for each tool that has touched tissue lately (0.1 s)
  std::vector<StageTime> stages;
  double stepMedian = 0, stepWorst = 0;  // s, over the last second
  double realTimeFactor = 1;             // simulated over elapsed time, over the last second
  bool moves = false;                    // the tissue is elastic
  std::vector<double> forces;            // of the tissue on each tool as a hand feels it, N
  std::vector<std::string> faults;       // of the last frame
};

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
  bool take(SurfaceUpdate& update, LiveState& state);

  // The surface where it is now, for saving; waits for the frame in work, and no longer.
  SurfaceTracker::Compact surface();
  // Waits until at least this frame has been done (for tests).
  void waitFor(std::int64_t frame);

 private:
  void work();
  void publish(const StepReport& report);
  void findUnseen(std::span<const IndexRange> changed);

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
  SurfaceUpdate update_;
  std::size_t updateVertices_ = 0;
  std::vector<Vec3f> published_;      // of moving tissue: where each vertex was last said to be
  std::vector<std::uint8_t> unseen_;  // 1 for each chunk of these that has not been taken yet
  LiveState state_;
  std::vector<std::vector<double>> laps_;  // per stage, ring of the last second
  std::vector<double> steps_, arrivals_;
  std::vector<double> lastTouch_;  // simulated time, s, per tool
  std::thread thread_;
};

}  // namespace resect
