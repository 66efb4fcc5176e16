// The surface with which an organ's tissue touches obstacles: the organ's surface before the
// operation.
#pragma once

#include <vector>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// Returns one patch for each triangle of the surface at iso level 50, in ascending order of
// SurfacePatch::cell, the particle nearest to the triangle's centre. Triangles without a particle
// at most two cells away, along each axis, are left out. `organ` must not have been edited yet. So
// the patches depend on organ.rest alone, and are the same for every state of the operation.
std::vector<SurfacePatch> touchSurface(const Organ& organ);

}  // namespace resect
