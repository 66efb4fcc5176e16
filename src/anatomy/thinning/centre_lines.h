// Centre lines of vessels that are given as solid shapes: trees of segments with their radii.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/thinning/solid_shape.h"

namespace resect {

// The segments of all connected parts of the shape; each segment comes after its parent, as in an
// Anatomy. The segments follow the middle of the shape with an error of at most 0.45 of the
// vessel's radius. In the first and last segments of a vessel, the error is at most one radius
// (test/anatomy/centre_lines_test.cpp). A branch begins at the middle of the vessel that it leaves.
// Radii are computed from SolidShape::depth, with an error of about half a cell of the shape's
// lattice. Vessels thinner than two cells are lost or get too large a radius.
//
// The root of a vessel is its widest end. Several hepatic veins come together at one point; the
// root of each vein is its end nearest to this point. All other ends are leaves. The result is
// empty if the shape is nowhere deeper than one cell.
std::vector<VesselSegment> centreLines(const SolidShape& shape, VesselKind kind);

}  // namespace resect
