// Interface of working parts: blade, jaws, hook, remover, one class each. A part finds what it
// touches and queues edits; it changes nothing itself, and it need not know whether the tissue
// moves.
#pragma once

#include <cstdint>
#include <vector>

#include "organ/edit.h"
#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

struct ToolModel;

// Pose, squeeze and pedal of a tool at one time.
struct ToolStance {
  Pose pose;           // world
  double squeeze = 1;  // of its jaws: 0 wide open, 1 closed
  double pedal = 0;    // of an energy device, 0 to 1: how far it is pressed

  template <class Visitor>
  void visit(Visitor& v) {
    v("pose", pose), v("squeeze", squeeze), v("pedal", pedal);
  }
};

// The way of a tool: its stances at the start of the frame before, at the start of this frame, and
// at its end.
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
  // overlap of organ and tool at the end of the frame, m^3; 0 for moving tissue.
  double overlapVolume = 0;
  // Still tissue: common part of the boxes of organ and moving tool; moving tissue: box round the
  // particles near the tool. Empty if they do not meet.
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
  // Called for each organ in each frame that the tool is in hand. Must be cheap and allocate
  // nothing when no tissue is near.
  virtual void act(const Touch& touch, std::vector<TissueEdit>& edits) const = 0;
};

}  // namespace resect
