// Interface of working parts. Blade, jaws, hook and remover are one class each. A part finds the
// tissue that it acts on and queues edits. It changes nothing itself, and it need not know whether
// the tissue moves.
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
  double squeeze = 1;  // how far its jaws are closed: 0 wide open, 1 closed
  double pedal = 0;    // how far the pedal of an energy device is pressed, 0 to 1

  template <class Visitor>
  void visit(Visitor& v) {
    v("pose", pose), v("squeeze", squeeze), v("pedal", pedal);
  }
};

// The way of a tool: its stances at the start of the frame before, at the start of this frame, and
// at the end of this frame.
struct ToolWay {
  ToolStance earlier, from, to;

  template <class Visitor>
  void visit(Visitor& v) {
    v("earlier", earlier), v("from", from), v("to", to);
  }
};

// What the body of one tool touches of one organ in one frame.
struct ToolContacts {
  std::int32_t tool = -1, organ = -1;
  std::vector<std::int64_t> cells;  // particles inside the volume that the tool swept, ascending
  // Overlap of organ and tool at the end of the frame, m^3; 0 for tissue that can move.
  double overlapVolume = 0;
  // For still tissue: the common part of the boxes of organ and moving tool. For tissue that can
  // move: the box round the particles near the tool. Empty if tool and organ do not meet.
  Aabb volumeOfInterest;
};

// One tool at one organ in one frame.
struct Touch {
  const ToolModel& model;
  const ToolWay& way;
  double duration;  // of the frame, s
  std::int32_t tool;
  std::int32_t organNumber;
  const Organ& organ;
  const TissueModel& tissue;
  const ToolContacts& contacts;

  TissueEdit edit(decltype(TissueEdit::what) what) const {
    return {organNumber, tool, std::move(what)};
  }
};

class WorkingPart {
 public:
  virtual ~WorkingPart() = default;
  // Called for each organ in each frame in which the tool is in hand. It must be cheap and allocate
  // nothing when no tissue is near.
  virtual void act(const Touch& touch, std::vector<TissueEdit>& edits) const = 0;
};

}  // namespace resect
