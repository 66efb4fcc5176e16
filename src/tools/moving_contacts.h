// What does a tool touch in tissue that moves: which particles, which bonds does its edge part,
// what lies in its bend?
//
// As tools/contacts.h, but where the particles are now. An edge parts a bond when the strip that it
// swept crosses the line between the two particles; the way of the frame before is tested again,
// for tissue may have moved through the edge meanwhile. Only motion along the blade parts tissue:
// moving sideways it pushes with its flat, moving back it leaves by the way it came. The edges of
// jaws part tissue while they close, wherever the tool goes meanwhile; the tool's surface is felt
// as that of open jaws throughout.
#pragma once

#include "tissue/tissue_model.h"
#include "tools/tool.h"

namespace resect {

// Where a tool is, and how far its jaws are squeezed: 0 wide open, 1 closed.
struct ToolStance {
  Pose pose;
  double squeeze = 0;
};

struct ToolWay {
  ToolStance earlier, from, to;  // at the start of the last frame, of this one, and at its end
};

ToolContacts findMovingContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                                std::int32_t toolIndex, const ToolWay& way);

// How far tissue keeps off a tool's surface, m: half a cell; blades and hooks come nearer, or they
// could not part or enter it.
double standOff(const ToolModel& tool, double spacing);

}  // namespace resect
