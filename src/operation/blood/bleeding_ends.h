// Lists the ends of cut vessels that bleed.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// The bleeding ends, with the flow of the last frame. BleedingEnd::place is here the present place
// of the vessel's end in the tissue, where an instrument reaches it. (In StepReport::blood it is
// where the blood comes out.) The result depends on the state alone, so it can also be computed
// after the operation was brought to another moment.
std::vector<BleedingEnd> bleedingEnds(const Simulation& simulation);

}  // namespace resect
