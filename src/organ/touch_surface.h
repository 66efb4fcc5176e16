// Where an organ's tissue touches obstacles: on the surface that it had before the operation.
#pragma once

#include <vector>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// One patch for each triangle of the surface at the middle iso level, 50, ascending by cell. It
// depends on organ.rest alone, so it is the same after a state was restored. organ: before the
// operation.
std::vector<SurfacePatch> touchSurface(const Organ& organ);

}  // namespace resect
