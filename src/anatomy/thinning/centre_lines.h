// Centre lines of vessels that are given as solid shapes: trees of segments with their radii.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/thinning/solid_shape.h"

namespace resect {

// The segments of all connected parts of the shape, each after its parent, as in Anatomy. They
// follow the middle of the shape to within 0.45 of the vessel's radius; in the first and last
// segments to within one radius (test/anatomy/centre_lines_test.cpp). A branch begins at the middle
// of the vessel that it leaves. Radii are computed from depths, to about half a cell: vessels
// thinner than two cells are lost or get too large a radius. The root is the widest end; if there
// are several hepatic veins, the root of each is its end nearest to the point where they come
// together. All other ends are leaves. Empty if the shape is nowhere deeper than one cell.
std::vector<VesselSegment> centreLines(const SolidShape& shape, VesselKind kind);

}  // namespace resect
