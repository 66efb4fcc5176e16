// The simulation of an operation, frame by frame: tools move, touch and act; tissue moves; the
// surface follows.
//
// A simulation uses no file, no window, and no clock but the one that times its stages. It is
// driven by its inputs alone: it runs without a display, several simulations can run in one
// process, and the same inputs give the same bits at any number of threads. docs/step.md walks
// through a step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "base/state/saved_state.h"
#include "blood/bleeding.h"
#include "organ/apply_edits.h"
#include "organ/operated_organ.h"
#include "tissue/joint.h"
#include "tissue/move_tissues.h"
#include "tools/tool.h"

namespace resect {

// Input for one tool in one frame.
struct ToolInput {
  Pose pose;           // at the end of the frame, world, m
  bool inHand = true;  // false: the tool is in the tool box or on its way there; it touches nothing
  double squeeze = 0;  // of a tool with jaws, at the end of the frame: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device: 0 released to 1 pressed
};

inline constexpr double kLongestFrame = 1;  // greatest duration of a frame, s

struct FrameInput {
  double duration = 1.0 / 60;    // s, 0 (nothing moves) to kLongestFrame
  std::vector<ToolInput> tools;  // one per tool, in the order of Simulation::tools
  std::optional<float> iso;      // if given: another iso level from this frame on
  // Edits from outside. They are applied before those that working parts queue in this frame. The
  // working parts do not see their effect before the next frame.
  std::vector<TissueEdit> edits;
  // The hand let go before this frame: what follows is another stroke (operation/live/strokes.h).
  // No stage of the step reads it.
  bool strokeEnds = false;
};

// A vessel of which more was cut in a frame.
struct CutVessel {
  std::int32_t organ = 0, segment = -1;
};

// Result of a frame. Output only: no stage reads it.
// Smoke: steam out of tissue that boils.
struct Smoke {
  std::int32_t organ = 0, tool = -1;  // the tool that heats it; -1: none
  Vec3 place = Vec3::Zero();          // where it is heated, world, m
  double rate = 0;                    // kg/s
};

struct StepReport {
  std::int64_t frame = 0;              // number of the frame, from 0
  double time = 0;                     // at the end of the frame, s
  std::int64_t removed = 0;            // number of particles removed
  double removedVolume = 0;            // volume removed, m^3
  std::int64_t severed = 0, torn = 0;  // number of bonds severed by cuts and edits; that tore
  std::int64_t touchedBricks = 0;      // number of bricks evaluated and meshed again
  // One entry per tool and organ: tool after tool, and for each tool organ after organ. The entry
  // of a tool that is not in hand has no particles.
  std::vector<ToolContacts> contacts;
  std::vector<TissueEdit> edits;  // of input and tools, in order; skipped ones (apply_edits.h) too
  std::vector<TissueEdit>
      caused;  // by the tissue's step: cuts, bonds that tore, grips that slipped
  std::vector<TissueStep> tissue;   // one per organ
  std::vector<CutVessel> vessels;   // vessels that were cut further in the frame
  BloodReport blood;                // if any organ has vessels
  std::vector<Smoke> smoke;         // one at most per instrument that heats
  std::vector<Vec3> toolForce;      // on each tool, mean over the frame, N; zero if no tissue moves
  std::vector<std::string> faults;  // sentences, each naming the setting to change
};

struct ToolState {
  ToolWay way;
  // Force on the tool, N. force: mean over the last frame. feltForce: smoothed over 0.05 s, as a
  // hand feels it.
  Vec3 force = Vec3::Zero(), feltForce = Vec3::Zero();
  bool inHand = false;
  bool wasInHand = false;  // inHand in the frame before
  std::unique_ptr<Tool> tool;

  const Pose& pose() const { return way.to.pose; }

  template <class Visitor>
  void visit(Visitor& v) {
    v("way", way), v("force", force), v("feltForce", feltForce);
    v("inHand", inHand), v("wasInHand", wasInHand);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(tool);
  }
};

class Simulation {
 public:
  // organs: at least one. joints: each joins cells of two organs, which it gives by their numbers.
  // Throws Error if a joint names an organ or a cell that does not exist, or has a number that is
  // out of range. table: whether there is a table, with its top at y = 0, on which moving tissue
  // can rest.
  Simulation(std::vector<OperatedOrgan> organs, std::vector<std::unique_ptr<Tool>> tools,
             std::vector<TissueJoint> joints = {}, bool table = true);
  // For one organ. tissue: null for still tissue.
  Simulation(Organ organ, std::vector<std::unique_ptr<Tool>> tools,
             std::unique_ptr<TissueModel> tissue = nullptr, bool table = true);
  // Adds an obstacle that stands still, such as the tool box: a closed body that moving tissue
  // cannot enter. Call before the first step. Has no effect if no tissue moves.
  void addObstacle(const TriangleMesh& shape, const Pose& pose);

  // Computes one frame. `clock`, if given, gets a lap per stage, under the stage's name. In these
  // cases it throws Error and changes nothing:
  //
  //   - the number of tools in the input is not that of tools();
  //   - the input's duration is out of range;
  //   - an edit names an organ or a tool that does not exist;
  //   - an edit is a grip with a pose that is not finite.
  //
  // If it is stopped by base/stop.h, call restore(), or destroy the simulation.
  StepReport step(const FrameInput& input, StageClock* clock = nullptr);
  // The same with a report that the caller uses again and again. Then a frame of still tissue that
  // no tool comes near allocates no memory.
  void step(const FrameInput& input, StepReport& report, StageClock* clock = nullptr);

  const std::vector<OperatedOrgan>& organs() const { return organs_; }
  const std::vector<TissueJoint>& joints() const { return joints_; }
  const std::vector<ToolState>& tools() const { return tools_; }
  double time() const { return time_; }
  std::int64_t frame() const { return frame_; }
  bool moves() const;  // whether the tissue of any organ moves

  // For simulations with one organ: data of the first organ.
  const Organ& organ() const { return organs_[0].organ; }
  const TissueModel& tissue() const { return *organs_[0].tissue; }
  std::span<const Vec3f> surfacePoints() const { return organs_[0].points(); }

  // The present surface of all organs as one mesh, world, m. The holes of the surface's arrays are
  // left out.
  TriangleMesh surfaceMesh() const;

  // From now on each step also updates normals and cut shares. Only pictures need them.
  void keepLook();
  // The mesh of surfaceMesh() with normals and cut shares. Throws Error unless keepLook() was
  // called before.
  SurfaceTracker::Compact surface() const;

  // Blood of this operation; organs without vessels do not bleed.
  const Bleeding& blood() const { return blood_; }

  // Memory held for organs, their tissue and surfaces, bytes.
  std::size_t bytes() const;

  // The whole state, for restore(). Size: at most 48 bytes per particle of elastic tissue, or one
  // bit per particle of still tissue; and the data of cuts. Cost: about one pass over the state.
  Bytes save() const;
  // Continues from a state that save() gave for the same organs and the same number of tools. From
  // then on the same inputs give the same bits. Normals and cut shares are made anew. If the state
  // is of other organs or is damaged, Error is thrown and nothing changes.
  void restore(std::span<const std::byte> state);
  // The state by its fields, for comparison (base/state/saved_state.h).
  SavedState fields() const { return saveState(*this, fingerprint()); }

  // Digest of the state and of the points and triangles of the surface. Normals and cut shares are
  // left out.
  std::uint64_t stateHash() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("frame", frame_), v("time", time_);
    v.fixed("organs", organs_), v.fixed("tools", tools_), v("joints", joints_);
    v("blood", blood_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(table_, keepsLook_, shapes_, standingShapes_, standingPoses_, joined_, work_);
  }

 private:
  // Data that one stage of a frame passes to later ones. The memory is used again in each frame.
  struct Work {
    std::vector<ToolContacts> contacts;
    std::vector<TissueEdit> edits, caused;
    std::vector<TissueEdit> applied;  // both, for heat and blood
    std::vector<HeatSource> heat;
    std::vector<std::vector<std::int64_t>> removedCells;       // by organ
    std::vector<std::span<const std::int64_t>> touchedBricks;  // by organ
    std::vector<std::vector<CuttingEdge>> edges;               // by tool
    std::vector<std::vector<Obstacle>> obstacles;              // by organ
    std::vector<MovingTissue> moving;
  };

  void requireSound(const FrameInput& input) const;
  void requireSound(const TissueJoint& joint) const;
  void moveTools(const FrameInput& input, StepReport& report);
  void findContacts();
  void actTools(const FrameInput& input);
  void applyEdits(StepReport& report);
  void moveTissue(const FrameInput& input, StepReport& report);
  void listMoving(const FrameInput& input, StepReport& report);
  void applyCuts(StepReport& report);
  void updateField(StepReport& report);
  void updateSurface(const FrameInput& input);
  void heatTissue(const FrameInput& input, StepReport& report);
  void flowBlood(const FrameInput& input, StepReport& report);
  void measure(const FrameInput& input, StepReport& report);

  EditSummary apply(std::span<const TissueEdit> edits, StepReport& report);
  void dropJoints();
  void findJoined();
  std::uint64_t fingerprint() const;
  void load(const SavedState& state);

  // State.
  std::vector<OperatedOrgan> organs_;
  std::vector<ToolState> tools_;
  std::vector<TissueJoint> joints_;
  Bleeding blood_;
  double time_ = 0;
  std::int64_t frame_ = 0;

  // Set up once, or derived from the state.
  bool table_, keepsLook_ = false;
  std::vector<std::unique_ptr<SignedDistance>> shapes_;          // of the tools, if tissue moves
  std::vector<std::unique_ptr<SignedDistance>> standingShapes_;  // from addObstacle()
  std::vector<Pose> standingPoses_;
  std::vector<JoinedOrgan> joined_;  // by organ, if there are joints
  Work work_;
};

}  // namespace resect
