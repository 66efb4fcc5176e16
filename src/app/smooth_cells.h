// How large cells must be for a simulation to keep real time.
#pragma once

#include "operation/live/live_state.h"

namespace resect {

// Side of the cells, mm, with which an operation would keep real time; 0 if it does already.
// frameRate: simulated frames per second. cell: present side of the cells, m. The work grows with
// the number of cells and with the number of time steps, so with the fourth power of 1 / side.
int smoothCells(const LiveState& state, double frameRate, double cell);

}  // namespace resect
