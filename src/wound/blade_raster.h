// Severs the grid edges that a blade crosses, and records the blade's traces: the lines in which
// the blade crosses the faces of the grid. The grid is that of the colour field, the scalar field
// whose isosurface is the organ's surface. Both blade and grid are in rest space.
//
// The sweep of the blade is the surface over which the blade's edge has moved, as triangles. The
// grid edges are tested against these triangles. The test is exact, and the same as for bonds
// between particles, the cells of tissue (collision/swept_blade.h). Triangles include their
// borders. A node on the plane of a triangle counts as above this plane. Bricks are blocks of 4 x 4
// x 4 nodes. Cost: some microseconds for each pair of a brick and a triangle that meet each other.
//
// A shallow cut, which parts the skin but ends above the first edge in tissue, is continued
// straight to that edge (belowShallowCut() in wound/wound_faces.h). So the line of a cut in the
// skin has no holes, however shallow the cut is. Such a cut gets deeper by less than one node
// spacing.
#pragma once

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

// How many cuts there may be between two neighbouring lattice cells. A grid line that leads from
// one cell towards the other has a stretch between the mid-planes of the two cells (the planes
// through their centres). With several nodes per cell, this stretch consists of several grid edges.
// Any: several edges of a stretch may be severed. One: at most one edge of a stretch may be
// severed. Moving tissue needs One, since tissue between two cuts in one stretch would have no
// particle to follow.
enum class CutsBetweenCells { Any, One };

// Severs edges in all bricks of the field in which the blade can meet tissue. Returns the number of
// edges that this call severed. iso: level of the organ's surface.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, float iso,
                         const SweptBlade& blade, CutsBetweenCells cuts = CutsBetweenCells::Any);

}  // namespace resect
