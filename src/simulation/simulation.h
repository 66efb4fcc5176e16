// The simulation of an operation, frame by frame: tools move, touch and act; tissue moves; the
// surface follows.
//
// A simulation uses no file and no window. So it runs without a display, and several simulations
// can run in one process. A clock only measures the time of the stages. The inputs alone determine
// the results: the same inputs give the same bits at any number of threads. docs/step.md describes
// a step stage by stage.
#pragma once

#include <array>
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
#include "simulation/surroundings.h"
#include "tissue/joint.h"
#include "tissue/move_tissues.h"
#include "tools/tool.h"

namespace resect {

// Input for one tool in one frame.
struct ToolInput {
  Pose pose;           // at the end of the frame, world, m
  bool inHand = true;  // false: the tool is in the tool box or on its way there; it touches nothing
  double squeeze = 0;  // of the tool's jaws at the end of the frame: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device at the end of the frame: 0 released, 1 pressed
};

inline constexpr double kLongestFrame = 1;  // greatest duration of a frame, s

struct FrameInput {
  double duration = 1.0 / 60;    // s, 0 (nothing moves) to kLongestFrame
  std::vector<ToolInput> tools;  // one per tool, in the order of Simulation::tools
  std::optional<float> iso;      // if given: new iso level, valid from this frame on
  // Edits from outside, such as those of a script. They are applied before the edits of the tools'
  // working parts (tools/working_part.h). The working parts queue their edits before any edit of
  // the frame is applied. So edits from outside affect the edits of working parts from the next
  // frame on.
  std::vector<TissueEdit> edits;
  // Whether the user let go of the input device before this frame. This ends a stroke, a period in
  // which instruments work on organs (operation/live/strokes.h). No stage of the step reads this.
  bool strokeEnds = false;
  // If given: from this frame on the patient breathes, or holds the breath (Breath::on). Has no
  // effect if the simulation has no breathing.
  std::optional<bool> breathes = {};
};

// A segment of a vessel. organ: number of the organ. segment: number of the segment in the organ.
struct CutVessel {
  std::int32_t organ = 0, segment = -1;
};

// Smoke: steam out of tissue that boils.
struct Smoke {
  std::int32_t organ = 0, tool = -1;  // the tool that heats the tissue; -1: none
  Vec3 place = Vec3::Zero();          // where the tissue is heated, world, m
  double rate = 0;                    // kg/s
};

// Result of a frame. Output only: no stage reads the result of an earlier frame.
struct StepReport {
  std::int64_t frame = 0;    // number of the frame, from 0
  double time = 0;           // at the end of the frame, s
  std::int64_t removed = 0;  // number of particles removed
  double removedVolume = 0;  // volume removed, m^3
  // A bond connects two neighbouring particles. severed: number of bonds severed by cuts and edits.
  // torn: number of bonds torn by load.
  std::int64_t severed = 0, torn = 0;
  // Number of bricks that were evaluated and meshed again. A brick is a block of nodes of the
  // colour field (sph/colour_field.h).
  std::int64_t touchedBricks = 0;
  // One entry for each pair of a tool and an organ. The entries of one tool follow each other, in
  // the order of the organs. If a tool is not in hand, its entries have no particles.
  std::vector<ToolContacts> contacts;
  // edits: first the edits of the input, then the edits that tools queued. Edits that were skipped
  // (apply_edits.h) are included. caused: edits for cuts, tears and slipped grips, which the motion
  // of tissue and blades has caused.
  std::vector<TissueEdit> edits;
  std::vector<TissueEdit> caused;
  std::vector<TissueStep> tissue;  // one per organ
  std::vector<CutVessel> vessels;  // vessels that were cut, or cut further, in the frame
  std::vector<CutVessel> slipped;  // vessels from which clips slipped; one entry per clip
  BloodReport blood;               // meaningful only if an organ has vessels
  std::vector<Smoke> smoke;        // for each organ whose tissue boils: one per Heat edit in it
  // Per tool: mean force on the tool over the frame, N; zero if no tissue moves.
  std::vector<Vec3> toolForce;
  std::vector<std::string> faults;  // sentences: what went out of range, and what to change
};

struct ToolState {
  ToolWay way;
  // force: mean force on the tool over the last frame, N. feltForce: this force smoothed with a
  // time constant of 0.05 s, as a hand feels it, N.
  Vec3 force = Vec3::Zero(), feltForce = Vec3::Zero();
  bool inHand = false;
  bool wasInHand = false;  // value of `inHand` in the previous frame
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
  // organs: at least one, each with a tissue model. tools: none is null. joints: each joins cells
  // of two organs. Throws Error if one of these conditions does not hold, if a joint names an organ
  // or a cell that does not exist, or if a joint has a value out of range. table: whether there is
  // a table, with its top at y = 0, on which moving tissue can rest.
  Simulation(std::vector<OperatedOrgan> organs, std::vector<std::unique_ptr<Tool>> tools,
             std::vector<TissueJoint> joints = {}, bool table = true);
  // A simulation of one organ. tissue: null for still tissue.
  Simulation(Organ organ, std::vector<std::unique_ptr<Tool>> tools,
             std::unique_ptr<TissueModel> tissue = nullptr, bool table = true);
  // Sets what stands round the organs: bodies that moving tissue cannot enter, and the table's
  // edge. Replaces what an earlier call has set. Without a call, there are no bodies, and the table
  // has no end. Call before the first step. Has no effect if no tissue moves.
  void surround(Surroundings surroundings);
  const Surroundings& surroundings() const { return surroundings_; }

  // Lets the patient breathe: the attachments of moving tissue, and the table under the tissue,
  // then move. Call before the first step. Has no effect if the depth is 0 or if no tissue moves.
  // Throws Error if a value is out of range.
  void setBreathing(const Breathing& breathing);

  // Computes one frame. If `clock` is given, it gets the time of each stage under the stage's name.
  // In the following cases step() throws Error and changes nothing:
  //
  //   - the number of tools in the input differs from the number of tools();
  //   - the input's duration is out of range;
  //   - an edit of the input names an organ, a tool or a cell that does not exist;
  //   - an edit of the input is a grip with a pose that is not finite.
  //
  // If the step is cancelled (base/stop.h), call restore() or destroy the simulation.
  StepReport step(const FrameInput& input, StageClock* clock = nullptr);
  // As above, but writes to a report that the caller reuses from frame to frame. If the tissue is
  // still and no tool is near it, the step then allocates no memory.
  void step(const FrameInput& input, StepReport& report, StageClock* clock = nullptr);

  const std::vector<OperatedOrgan>& organs() const { return organs_; }
  const std::vector<TissueJoint>& joints() const { return joints_; }
  const std::vector<ToolState>& tools() const { return tools_; }
  double time() const { return time_; }
  std::int64_t frame() const { return frame_; }
  bool moves() const;  // whether the tissue of any organ moves
  // How the patient breathes, and the present breath. Without breathing, Breathing::depth is 0.
  const Breathing& breathing() const { return breathing_; }
  const Breath& breath() const { return breath_; }

  // Shortcuts for simulations with one organ: data of the first organ.
  const Organ& organ() const { return organs_[0].organ; }
  const TissueModel& tissue() const { return *organs_[0].tissue; }
  std::span<const Vec3f> surfacePoints() const { return organs_[0].points(); }

  // The present surface of all organs as one mesh, world, m.
  TriangleMesh surfaceMesh() const;

  // From now on each step also updates the vertices' normals and cut shares. Only pictures need
  // them. A cut share goes from 0 on the organ's original surface to 1 on cut faces.
  void keepLook();
  // The mesh of surfaceMesh() with normals and cut shares. Throws Error if keepLook() was not
  // called before.
  SurfaceTracker::Compact surface() const;

  // The blood of all organs; organs without vessels do not bleed.
  const Bleeding& blood() const { return blood_; }

  // Memory held for organs, their tissue and surfaces, bytes.
  std::size_t bytes() const;

  // The whole state, for restore(). Size: at most 48 bytes per particle of elastic tissue, one bit
  // per particle of still tissue, and the data of cuts. Cost: about one pass over the state.
  Bytes save() const;
  // Continues from a state that save() gave for the same organs and the same number of tools. From
  // then on the same inputs give the same bits as they gave after save(). Normals and cut shares
  // are computed again. Throws Error, and changes nothing, if the state belongs to other organs or
  // is damaged.
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
    if (breathing_.depth > 0) v("breath", breath_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(table_, keepsLook_, halfDone_, shapes_, surroundings_, standingShapes_, joined_, work_);
    v.made(breathing_);
    if (!(breathing_.depth > 0)) v.made(breath_);
  }

 private:
  // Data that one stage of a frame passes to later stages. The memory is used again in each frame.
  struct Work {
    std::vector<ToolContacts> contacts;
    std::vector<TissueEdit> edits, caused;
    std::vector<TissueEdit> applied;  // `edits`, then `caused`; input of heat and blood
    std::vector<HeatSource> heat;
    std::vector<std::vector<std::int64_t>> removedCells;       // per organ
    std::vector<std::span<const std::int64_t>> touchedBricks;  // per organ
    std::vector<std::vector<CuttingEdge>> edges;               // per tool
    std::vector<std::vector<Obstacle>> obstacles;              // per organ
    std::vector<MovingTissue> moving;
    // How far breathing displaces the table at the start and at the end of the frame, m.
    std::array<Vec3, 2> table{Vec3::Zero(), Vec3::Zero()};
  };

  void requireSound(const FrameInput& input) const;
  void requireSound(const TissueJoint& joint) const;
  void moveTools(const FrameInput& input, StepReport& report);
  void findContacts();
  void actTools(const FrameInput& input);
  void applyEdits(StepReport& report);
  void moveTissue(const FrameInput& input, StepReport& report);
  void listMoving(const FrameInput& input, StepReport& report);
  void moveHolds(const FrameInput& input);
  void addTable(std::vector<Obstacle>& obstacles) const;
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
  Breath breath_;
  double time_ = 0;
  std::int64_t frame_ = 0;

  // Set up once, or derived from the state.
  bool table_, keepsLook_ = false;
  bool halfDone_ = false;  // a step or a restore was begun and not ended: it was stopped
  Breathing breathing_;
  std::vector<std::unique_ptr<SignedDistance>> shapes_;  // per tool; empty if no tissue moves
  Surroundings surroundings_;
  std::vector<std::unique_ptr<SignedDistance>> standingShapes_;  // of surroundings_.bodies
  std::vector<JoinedOrgan> joined_;  // per organ; empty if there are no joints
  Work work_;
};

}  // namespace resect
