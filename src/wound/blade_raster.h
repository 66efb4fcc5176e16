// Severs the grid edges that a blade crosses, and records the blade's traces on the faces of the
// grid. The blade and the grid are in rest space.
//
// The edges are tested against the triangles of the blade's sweep. The test is exact, and the same
// as for bonds between particles (collision/swept_blade.h). Triangles include their borders. A node
// on the plane of a triangle counts as above this plane. Cost: some microseconds for each pair of a
// brick and a triangle of the sweep that meet each other.
#pragma once

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

// How many cuts there may be between two neighbouring cells. A grid line that leads from one cell
// towards the other has a stretch between the mid-planes of the two cells. With several nodes per
// cell, this stretch consists of several grid edges. Any: all edges of a stretch may be severed.
// One: at most one edge of a stretch may be severed. Moving tissue needs One, since tissue between
// two cuts in one stretch would have no particle to follow.
enum class CutsBetweenCells { Any, One };

// Severs edges in all bricks of the field in which the blade can meet tissue. Returns the number of
// edges that this call severed.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                         CutsBetweenCells cuts = CutsBetweenCells::Any);

}  // namespace resect
