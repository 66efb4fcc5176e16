// Severs the grid edges that a blade crosses between two poses, and records the blade's traces on
// the faces of the grid.
//
// The grid moves with the tissue. First the present positions of its nodes are computed. Then the
// edges between the nodes are tested against the triangles of the blade's sweep. The test is the
// exact one that is used for bonds between particles (collision/swept_blade.h): triangles include
// their borders, and a node on the plane of a triangle counts as above it. The results are stored
// in rest space. Cost: some microseconds for each pair of a brick and a triangle that meet.
#pragma once

#include <functional>
#include <span>

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

constexpr int kPlacedNodes = 125;  // the 5 x 5 x 5 nodes on which a brick's edges and faces lie
// Writes the present positions (world, m) of the nodes of `brick` to `places`, x fastest. A node
// that is too far from tissue to have a position gets NaN. The edges of this node cannot be
// severed.
using PlaceNodes = std::function<void(const Vec3i& brick, std::span<Vec3, kPlacedNodes> places)>;

// How many cuts there may be between two neighbouring cells. Each grid line that leads from one
// cell towards the other has a stretch between the mid-planes of the two cells; with several nodes
// per cell this stretch consists of several edges. Any: each of these edges may be severed. One: at
// most one of them. Moving tissue needs One: between two cuts in one stretch there would be tissue
// without a particle to follow.
enum class CutsBetweenCells { Any, One };

// Severs the edges of `bricks` that the blade crosses, and records its traces on their faces.
// Returns the number of edges that were severed by this call.
std::int64_t severAlong(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                        std::span<const std::int64_t> bricks, const PlaceNodes& place,
                        CutsBetweenCells cuts = CutsBetweenCells::Any);

// The same for tissue at rest, in all bricks of the field in which the blade can meet tissue.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade);

}  // namespace resect
