// Centre lines of vessels that are given as solid shapes: trees of segments with their radii.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/thinning/solid_shape.h"

namespace resect {

// The segments of all connected parts of the shape, in the order of Anatomy. They follow the middle
// of the shape, at its ends to 0.4 of the vessel's radius; branches begin at the middle of the
// vessel that they leave. Radii come from depths, to about half a cell: vessels thinner than two
// cells are lost or too wide. The root is the widest end; for several
// hepatic veins, the end where they come together. Other ends count as ending among the sinusoids.
// Empty if the shape is nowhere deeper than a cell.
std::vector<VesselSegment> centreLines(const SolidShape& shape, VesselKind kind);

}  // namespace resect
