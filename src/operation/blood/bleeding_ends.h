// Lists the ends of cut vessels that bleed or draw in air.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// The ends that bleed or draw in air, with the flow of the last frame. Here BleedingEnd::place is
// the present position of the vessel's end in the tissue, where an instrument can reach the vessel.
// (In StepReport::blood, BleedingEnd::place is the point where the blood comes out.) The result
// depends on the state alone. So this function can also be called after an undo or a jump to
// another moment of the operation.
std::vector<BleedingEnd> bleedingEnds(const Simulation& simulation);

}  // namespace resect
