// A map of the labelled structures inside an organ, for viewers.
#pragma once

#include <memory>

#include "organ/organ.h"
#include "surface/tissue_map.h"

namespace resect {

// The cells whose present label is above 0, in two classes: tumours (by structureKind() of the
// label's name) and all others. The map has no texels if there are no such cells. Cost: a pass over
// all cells.
std::shared_ptr<const TissueMap> pictureStructures(const Organ& organ);

}  // namespace resect
