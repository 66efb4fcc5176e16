// Contacts: the particles that a tool's body touches on its way from one pose to the next.
//
// Broad phase: particles whose present positions are in the tool's box; a tool away from the organ
// costs a box test. Then the exact swept test (collision/inside.h), which misses no particle
// however far the tool jumps and however thin it is.
#pragma once

#include "tools/tool.h"

namespace resect {

// `from`, `to`: poses at the ends of the step. The overlap volume is that of tool and organ at
// `to`, before the tool acts. It is measured with layered depth images of both surfaces, 32 pixels
// across the volume of interest; intervals along z are exact, so the error is that of the pixels,
// about 5 % for a scalpel's blade. It is not measured for tissue that moves. The caller sets tool
// and organ of the result.
ToolContacts findContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                          const Pose& from, const Pose& to);

// Stand-off of tissue from a tool's surface, m: half a cell; less for blades and hooks, which must
// come nearer to cut or enter tissue.
double standOff(const ToolModel& tool, double spacing);

}  // namespace resect
