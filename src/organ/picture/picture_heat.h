// A map of the damage that heat has done to an organ, for viewers.
#pragma once

#include <memory>

#include "organ/operated_organ.h"
#include "surface/tissue_map.h"

namespace resect {

// How far the tissue round the heated spots is coagulated and burnt (TissueMap). The map has no
// texels if there are no heated spots. Cost: proportional to the volume of the box round these
// spots.
std::shared_ptr<const TissueMap> pictureHeat(const OperatedOrgan& organ);

}  // namespace resect
