// Where cut vessels bleed.
#pragma once

#include <vector>

#include "simulation/simulation.h"

namespace resect {

// The ends that bleed, with the flow of the last frame. Their places are those of the vessels' ends
// in the tissue, where an instrument reaches them; StepReport::blood has those where the blood
// comes out. From the state alone, so that they are known after the operation was brought to
// another moment, too.
std::vector<BleedingEnd> bleedingEnds(const Simulation& simulation);

}  // namespace resect
