// Which particles does a tool touch while it moves from one pose to the next?
//
// Broad phase: rows of cells are clipped against the tool's box; a tool away from the organ costs a
// box test. Then the exact swept inside test (collision/inside.h), so that a tool that jumps far
// skips nothing, however thin it is.
#pragma once

#include "tools/tool.h"

namespace resect {

// `from`, `to`: poses at the ends of the step. The overlap volume is that at `to`, before the tool
// acts: what it would take if tissue were water. It is measured by layered depth images of both
// surfaces, 32 pixels across the volume of interest; the images hold exact stretches along z, so
// what is left is the pixels' share of a thin tool, about 5 % of a scalpel's blade.
ToolContacts findContacts(const Organ& organ, const Tool& tool, std::int32_t toolIndex,
                          const Pose& from, const Pose& to);

}  // namespace resect
