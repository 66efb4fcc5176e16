// Severs the grid edges that a blade crosses, and records the blade's traces on the faces of the
// grid. The blade and the grid are in rest space.
//
// The edges are tested against the triangles of the blade's sweep. The test is the same exact test
// as for bonds between particles (collision/swept_blade.h): triangles include their borders, and a
// node on the plane of a triangle counts as above it. Cost: some microseconds for each pair of a
// brick and a triangle of the sweep that meet.
#pragma once

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

// How many cuts there may be between two neighbouring cells. Each grid line that leads from one
// cell towards the other has a stretch between the mid-planes of the two cells; with several nodes
// per cell this stretch consists of several edges. Any: each of these edges may be severed. One: at
// most one of them may be severed. Moving tissue needs One: the tissue between two cuts in one
// stretch would have no particle to follow.
enum class CutsBetweenCells { Any, One };

// Severs edges in all bricks of the field in which the blade can meet tissue. Returns the number of
// edges that this call severed.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                         CutsBetweenCells cuts = CutsBetweenCells::Any);

}  // namespace resect
