// What happens in one frame of an operation? Tools move, touch, act; tissue answers; the surface
// follows.
//
// A simulation knows no file, window, thread or clock: it is driven by inputs alone, so it runs
// headless, several times in one process, and gives the same bits for the same inputs at any number
// of threads. docs/step.md walks through a step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "organ/organ.h"
#include "organ/skin.h"
#include "tissue/tissue_model.h"
#include "tools/contacts.h"
#include "tools/tool.h"

namespace resect {

// What the outside says about a tool for this frame.
struct ToolInput {
  Pose pose;           // at the end of the frame, world, m
  bool inHand = true;  // false: it lies in the tool box, or is being put there, and touches nothing
  double squeeze = 0;  // of a tool with jaws, at the end of the frame: 0 wide open, 1 closed
};

struct FrameInput {
  double duration = 1.0 / 60;    // s
  std::vector<ToolInput> tools;  // one per tool, in the order of Simulation::tools
  std::optional<float> iso;      // another iso level from this frame on
};

// What happened in a frame.
struct StepReport {
  std::int64_t frame = 0;              // number of the frame, from 0
  double time = 0;                     // at the end of the frame, s
  std::int64_t removed = 0;            // particles
  double removedVolume = 0;            // m^3
  std::int64_t touchedBricks = 0;      // bricks evaluated and meshed again
  std::vector<ToolContacts> contacts;  // one per tool; empty for a tool not in hand
  std::int64_t severed = 0;            // bonds cut by edges
  TissueStep tissue;                   // of tissue that moves
  std::vector<Vec3> toolForce;  // on each tool, mean over the frame, N; zero when it does not move
  std::vector<std::string> faults;  // sentences, each naming the setting to change
};

struct ToolState {
  std::unique_ptr<Tool> tool;
  Pose pose;
  Pose previousPose;                                            // at the start of the frame
  Pose earlierPose;                                             // at the start of the frame before
  double squeeze = 1, previousSqueeze = 1, earlierSqueeze = 1;  // of its jaws, at the same times
  // On the tool, N: of this frame, and smoothed over some 0.05 s as a hand feels it.
  Vec3 force = Vec3::Zero(), feltForce = Vec3::Zero();
  bool inHand = false;
  bool wasInHand = false;
};

class Simulation {
 public:
  // `tissue` null: it does not move. `table`: tissue that moves rests on a level top at y = 0.
  Simulation(Organ organ, std::vector<std::unique_ptr<Tool>> tools,
             std::unique_ptr<TissueModel> tissue = nullptr, bool table = true);

  // One frame. `clock`, when given, gets a lap per stage, under the stage's name.
  StepReport step(const FrameInput& input, StageClock* clock = nullptr);
  // The same into a report that is kept from frame to frame: then a frame in which no tool comes
  // near tissue allocates no memory.
  void step(const FrameInput& input, StepReport& report, StageClock* clock = nullptr);

  const Organ& organ() const { return organ_; }
  const std::vector<ToolState>& tools() const { return tools_; }
  const TissueModel& tissue() const { return *tissue_; }

  // The surface where it is now, in world space: that of the organ's tracker, moved with the
  // tissue. One point per vertex of the tracker's arrays.
  std::span<const Vec3f> surfacePoints() const;
  TriangleMesh surfaceMesh() const;  // without the arrays' holes

  // From now on each step keeps up how the surface looks, for pictures of it: nothing else of a
  // step depends on it.
  void keepLook();
  // Of a simulation that keeps its look. Normals: one per vertex of the tracker's arrays.
  std::span<const Vec3f> surfaceNormals() const;
  SurfaceTracker::Compact surface() const;  // surfaceMesh() and how it looks
  double time() const { return time_; }
  std::int64_t frame() const { return frame_; }
  // Memory held for the organ, its tissue and its surface where it is now.
  std::size_t bytes() const { return organ_.bytes() + tissue_->bytes() + skin_.bytes(); }

  // Digest of all that decides what comes next: cells, iso level, poses, time; and of the surface
  // (where it is, not how it looks).
  std::uint64_t stateHash() const;

 private:
  void moveTools(const FrameInput& input, StepReport& report);
  void findContacts(StepReport& report) const;
  void actTools(const StepReport& report);
  void applyEdits(StepReport& report);
  void moveTissue(const FrameInput& input, StepReport& report);
  void updateField(StepReport& report);
  void updateSurface(const FrameInput& input);
  void measure(const FrameInput& input, StepReport& report);

  Organ organ_;
  std::unique_ptr<TissueModel> tissue_;
  bool table_;
  bool keepsLook_ = false;
  std::vector<ToolState> tools_;
  std::vector<std::unique_ptr<SignedDistance>> shapes_;  // of the tools, for tissue that moves
  std::vector<TissueTool> tissueTools_;                  // of this frame
  std::vector<std::int64_t> changedCells_;               // removed in this frame
  std::vector<TissueBond> cutBonds_;                     // in this frame
  std::vector<std::int64_t> cutCells_;                   // near blades that cut in this frame
  SurfaceSkin skin_;
  std::vector<TissueEdit> edits_;                // queued in this frame
  std::span<const std::int64_t> touchedBricks_;  // of this frame
  double time_ = 0;
  std::int64_t frame_ = 0;
};

}  // namespace resect
