// Contacts: the particles (cells of tissue) that a tool's body touches on its way from one pose to
// the next.
//
// The broad phase finds the particles whose present positions are in the box round the tool's
// motion. If the tissue never moves and the tool is far away, this phase costs one box test. The
// particles that the broad phase finds are then tested exactly against the tool's sweep
// (collision/inside.h). No particle is missed, however far the tool moves in a frame and however
// thin the tool is.
#pragma once

#include "tools/tool.h"

namespace resect {

// from, to: the tool's poses at the start and end of the frame. The caller sets `tool` and `organ`
// of the result. If the tool touches particles of tissue that never moves, the overlap volume is
// measured too. This is the volume that tool and organ share at the pose `to`, before the tool
// acts. The volume is measured with layered depth images of both surfaces. These images have 32
// pixels along the longer side of the region where the two surfaces may meet. For each pixel, the
// parts of a line along z that lie inside both tool and organ are computed exactly. So only the
// size of the pixels causes an error: about 5 % for a scalpel's blade.
ToolContacts findContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                          const Pose& from, const Pose& to);

// Whether the tool must be able to enter tissue (Obstacle::enters): true if it has an edge, a hook
// or jaws.
bool entersTissue(const ToolModel& tool);

}  // namespace resect
