// The surface with which an organ's tissue touches obstacles: the organ's surface before the
// operation.
#pragma once

#include <vector>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Returns one patch for each triangle of the surface at iso level 50. SurfacePatch::cell is the
// particle nearest to the triangle's centre; the patches are in ascending order of this index. A
// triangle is left out if no particle lies within two cells of its centre along each axis.
// `organ` must not have been edited yet. So the patches depend on organ.rest alone, and are the
// same for every state of the operation.
std::vector<SurfacePatch> touchSurface(const Organ& organ);

}  // namespace resect
