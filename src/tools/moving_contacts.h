// What does a tool touch in tissue that moves: which particles, which bonds does its edge part,
// what lies in its bend?
//
// As tools/contacts.h, but where the particles are now. An edge parts a bond when the strip that it
// swept crosses the line between the two particles; the way of the frame before is tested again,
// for tissue may have moved through the edge meanwhile. Only motion along the blade parts tissue:
// moving sideways it pushes with its flat, moving back it leaves by the way it came.
#pragma once

#include "tissue/tissue_model.h"
#include "tools/tool.h"

namespace resect {

struct ToolWay {
  Pose earlier, from, to;  // at the start of the last frame, of this one, and at its end
};

ToolContacts findMovingContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                                std::int32_t toolIndex, const ToolWay& way);

// How far tissue keeps off a tool's surface, m: half a cell; blades and hooks come nearer, or they
// could not part or enter it.
double standOff(const ToolModel& tool, double spacing);

}  // namespace resect
