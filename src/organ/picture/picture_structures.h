// Structures inside an organ, as viewers draw them.
#pragma once

#include <memory>

#include "organ/organ.h"
#include "surface/tissue_map.h"

namespace resect {

// Where the labelled cells lie, by their present labels: tumours (structureKind() of the label's
// name), and all others. Without texels if there are none. Cost: all cells.
std::shared_ptr<const TissueMap> pictureStructures(const Organ& organ);

}  // namespace resect
