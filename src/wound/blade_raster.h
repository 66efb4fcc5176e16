// Severs the grid edges that a blade crosses between two poses and records its traces on the grid's
// faces.
//
// The grid moves with the tissue. The present positions of its nodes are computed; then the edges
// between them are tested against the triangles of the blade's sweep. The test is the exact one
// that is used for bonds between particles (closed intervals, a point on the plane counts as above:
// collision/swept_blade.h). The results are stored in rest space. Cost: some microseconds for each
// pair of a brick and a triangle that meet.
#pragma once

#include <functional>
#include <span>

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

constexpr int kPlacedNodes = 125;  // the 5 x 5 x 5 nodes on which a brick's edges and faces lie
// Writes the present positions (world, m) of a brick's nodes, x fastest. A node too far from tissue
// to have a position gets NaN; its edges cannot be severed.
using PlaceNodes = std::function<void(const Vec3i& brick, std::span<Vec3, kPlacedNodes> places)>;

// How often the line of grid edges between the mid-planes of two neighbouring cells may be severed:
// any number of times, or once. Moving tissue needs One: between two such cuts there would be
// tissue without a particle to follow.
enum class CutsBetweenCells { Any, One };

// Severs the edges of `bricks` that the blade crosses and records its traces on their faces.
// Returns the number of edges newly severed.
std::int64_t severAlong(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                        std::span<const std::int64_t> bricks, const PlaceNodes& place,
                        CutsBetweenCells cuts = CutsBetweenCells::Any);

// The same for tissue at rest, in all bricks of the field where the blade can meet tissue.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade);

}  // namespace resect
