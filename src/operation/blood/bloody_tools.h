// How far up from its tip each instrument has become bloody, for viewers.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// reach: for each tool, how far it is bloody from its tip along its axis, m. Each entry is raised
// to the farthest place, up to 8 cm, at which blood on an organ is within 5 mm of the axis in the
// present state. No entry becomes smaller, since tools are not wiped. Cost: proportional to the
// number of wet cells times the number of tools in hand.
void followBlood(const Simulation& simulation, std::vector<double>& reach);

}  // namespace resect
