// How far up from its tip each instrument has become bloody, for viewers.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// reach: one entry per tool: the length, m along the tool's axis from its tip, that is bloody. Each
// entry is raised to the farthest place, up to 8 cm, at which blood on an organ is within 5 mm of
// the axis now. It never becomes smaller, since tools are not wiped. Cost: proportional to the
// number of wet cells, for each tool in hand.
void followBlood(const Simulation& simulation, std::vector<double>& reach);

}  // namespace resect
