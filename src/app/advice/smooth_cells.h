// How large cells must be for a simulation to keep real time.
#pragma once

#include "operation/live/live_state.h"

namespace resect {

// Side of the cells, mm, with which an operation would keep real time. The result is 0 in these
// cases: the operation keeps real time already; none of its tissue is elastic; an earlier moment is
// shown; the side would have to be larger than 20 mm. frameRate: simulated frames per second. cell:
// present side of the cells, m. The computing time is assumed to be proportional to the number of
// cells times the number of time steps, that is, to 1 / side^4.
int smoothCells(const LiveState& state, double frameRate, double cell);

}  // namespace resect
