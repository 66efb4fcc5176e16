// For viewers: how far each instrument is bloody, measured from its tip.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// reach: for each tool, the length, m, over which it is bloody, measured along its axis from the
// tip. A tool in hand is made bloody by liquid blood on an organ if the blood is at least 0.05 mm
// thick, lies within 5 mm of the tool's axis, and lies at most 8 cm from the tip along this axis.
// If such blood is farther from the tip than the tool's entry in `reach`, the entry is raised to
// the distance of the blood. A gauze swab soaks blood up: under it, blood counts over its whole
// width, and the more of its underside is wet, the farther up it is red. No entry becomes smaller,
// since tools are not wiped. Cost: proportional to the number of cells with blood on them times the
// number of tools in hand.
void followBlood(const Simulation& simulation, std::vector<double>& reach);

}  // namespace resect
