// Which particles does a tool's body touch while it moves from one pose to the next?
//
// Broad phase: particles in the tool's box, where they are now; a tool away from the organ costs a
// box test. Then the exact swept inside test (collision/inside.h), so that a tool that jumps far
// skips nothing, however thin it is.
#pragma once

#include "tools/tool.h"

namespace resect {

// `from`, `to`: poses at the ends of the step. The overlap volume is that at `to`, before the tool
// acts: what it would take if tissue were water. It is measured by layered depth images of both
// surfaces, 32 pixels across the volume of interest; the images hold exact stretches along z, so
// what is left is the pixels' share of a thin tool, about 5 % of a scalpel's blade. Of tissue that
// moves it is not measured. tool and organ of the answer are left to the caller.
ToolContacts findContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                          const Pose& from, const Pose& to);

// How far tissue keeps off a tool's surface, m: half a cell; blades and hooks come nearer, or they
// could not part or enter it.
double standOff(const ToolModel& tool, double spacing);

}  // namespace resect
