// Contacts: the particles that a tool's body touches on its way from one pose to the next.
//
// The broad phase finds the particles whose present positions are in the box of the moving tool; a
// tool away from the organ costs one box test. These particles then undergo the exact swept test
// (collision/inside.h), which misses none however far the tool jumps and however thin it is.
#pragma once

#include "tools/tool.h"

namespace resect {

// from, to: poses at the start and end of the frame. The overlap volume is that of tool and organ
// at `to`, before the tool acts. It is measured with layered depth images of both surfaces, 32
// pixels across the volume of interest. The images' intervals along z are exact, so only the pixels
// cause an error: about 5 % for a scalpel's blade. The overlap volume is not measured for tissue
// that moves. The caller sets `tool` and `organ` of the result.
ToolContacts findContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                          const Pose& from, const Pose& to);

// Stand-off of tissue from a tool's surface, m: half a spacing, or a tenth for tools with an edge
// or a hook, which must come nearer to cut or enter tissue.
double standOff(const ToolModel& tool, double spacing);

}  // namespace resect
