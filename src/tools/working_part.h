// Interface of working parts. A working part is the part of an instrument that acts on tissue. A
// working part finds tissue and requests edits (changes) of this tissue, or it has edges that cut.
// A working part does not change tissue itself, and need not know whether the tissue moves. The
// working parts that come with Resect are in tools/parts/.
#pragma once

#include <cstdint>
#include <vector>

#include "organ/edit.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

struct ToolModel;

// Pose, squeeze and pedal of a tool at one moment.
struct ToolStance {
  Pose pose;           // world
  double squeeze = 1;  // of the jaws: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device: 0 released, 1 pressed

  template <class Visitor>
  void visit(Visitor& v) {
    v("pose", pose), v("squeeze", squeeze), v("pedal", pedal);
  }
};

// The way of a tool: its stances at the start and at the end of a frame.
struct ToolWay {
  ToolStance from, to;

  template <class Visitor>
  void visit(Visitor& v) {
    v("from", from), v("to", to);
  }
};

// The contact between one tool and one organ in one frame. Particles are cells of tissue.
struct ToolContacts {
  std::int32_t tool = -1, organ = -1;  // numbers of tool and organ in the simulation
  std::vector<std::int64_t> cells;     // particles inside the volume that the tool swept, ascending
  // Volume that organ and tool share at the end of the frame, m^3. It is measured only for tissue
  // that cannot move, and only if `cells` is not empty. Otherwise it is 0.
  double overlapVolume = 0;
  // A box in world coordinates, m. For tissue that cannot move: the common part of the organ's box
  // and the box round the tool's motion; empty if they have no common part. For tissue that can
  // move: the box round the particles near the tool; empty if no particle is near.
  Aabb volumeOfInterest;
};

// Input of a working part, for one tool and one organ in one frame.
struct Touch {
  const ToolModel& model;
  const ToolWay& way;
  double duration;           // of the frame, s
  std::int32_t tool;         // number of the tool in the simulation
  std::int32_t organNumber;  // number of the organ in the simulation
  const Organ& organ;
  const TissueModel& tissue;
  const ToolContacts& contacts;
  double force = 0;  // smoothed force of the tissue on the tool (ToolState::feltForce), N

  // Makes an edit of this organ by this tool.
  TissueEdit edit(decltype(TissueEdit::what) what) const {
    return {organNumber, tool, std::move(what)};
  }
};

class WorkingPart {
 public:
  virtual ~WorkingPart() = default;
  // Appends edits to `edits`. Called for each organ in each frame in which the tool is in hand.
  // When no tissue is near, a call must be cheap and allocate nothing.
  virtual void act(const Touch&, std::vector<TissueEdit>&) const {}
  // Appends the part's cutting edges. Called in each frame in which the tool is in hand. The tissue
  // model decides what the edges cut (tissue/cutting_edge.h). CuttingEdge::points must stay valid
  // during the frame.
  virtual void addEdges(const ToolModel&, const ToolWay&, std::vector<CuttingEdge>&) const {}
};

}  // namespace resect
