// How far up from its tip each instrument has become bloody, for viewers.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// Lengthens `reach`, one entry per tool, m along the tool's axis from its tip, to what wets it now:
// blood on an organ within 5 mm of the axis. Nobody wipes tools. Cost: the wet cells, for each tool
// in hand.
void followBlood(const Simulation& simulation, std::vector<double>& reach);

}  // namespace resect
