// How large cells must be for a simulation to keep real time.
#pragma once

#include "operation/live/live_state.h"

namespace resect {

// Side of the cells, mm, with which an operation would keep real time. 0 if the operation already
// keeps it, if none of its tissue is elastic, if an earlier moment is shown, or if more than 20 mm
// would be needed. frameRate: simulated frames per second. cell: present side of the cells, m. The
// work is taken as proportional to the number of cells times the number of time steps, and so to
// the inverse fourth power of the side.
int smoothCells(const LiveState& state, double frameRate, double cell);

}  // namespace resect
