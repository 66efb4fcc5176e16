// A map of the damage that heat has done to an organ, for viewers.
#pragma once

#include <memory>

#include "organ/operated_organ.h"
#include "surface/tissue_map.h"

namespace resect {

// Coagulated and charred shares round the heated spots; without texels if there are none. Cost:
// proportional to the volume of the box round these spots.
std::shared_ptr<const TissueMap> pictureHeat(const OperatedOrgan& organ);

}  // namespace resect
