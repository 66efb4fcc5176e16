// For viewers: how far each instrument is bloody, measured from its tip.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// reach: for each tool, the length, m, over which it is bloody, measured along its axis from the
// tip. For this, blood on an organ counts if in the present state it lies within 5 mm of the axis,
// and at most 8 cm up from the tip. If such blood lies farther up than the entry says, the entry is
// raised to this distance. No entry becomes smaller, since tools are not wiped. Cost: proportional
// to the number of cells with blood on them times the number of tools in hand.
void followBlood(const Simulation& simulation, std::vector<double>& reach);

}  // namespace resect
