// Severs the grid edges that a blade crosses, and records the blade's traces on the faces of the
// grid. Blade and grid are those of the tissue at rest.
//
// The edges are tested against the triangles of the blade's sweep. The test is the exact one that
// is used for bonds between particles (collision/swept_blade.h): triangles include their borders,
// and a node on the plane of a triangle counts as above it. Cost: some microseconds for each pair
// of a brick and a triangle that meet.
#pragma once

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

// How many cuts there may be between two neighbouring cells. Each grid line that leads from one
// cell towards the other has a stretch between the mid-planes of the two cells; with several nodes
// per cell this stretch consists of several edges. Any: each of these edges may be severed. One: at
// most one of them. Moving tissue needs One: between two cuts in one stretch there would be tissue
// without a particle to follow.
enum class CutsBetweenCells { Any, One };

// Cuts in all bricks of the field in which the blade can meet tissue. Returns the number of edges
// that were severed by this call.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                         CutsBetweenCells cuts = CutsBetweenCells::Any);

}  // namespace resect
