// Severs the grid edges that a blade crosses between two poses and records its traces on the grid's
// faces.
//
// The grid moves with the tissue: the present positions of its nodes are computed, then the edges
// between them are tested against the sweep's triangles by the same exact test as bonds between
// particles (closed intervals, a point on the plane counts as above: collision/swept_blade.h). The
// results are stored in rest space. Cost: some microseconds per brick and triangle that meet.
#pragma once

#include <functional>
#include <span>

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

constexpr int kPlacedNodes = 125;  // the 5 x 5 x 5 nodes on which a brick's edges and faces lie
// Writes the present positions (world, m) of a brick's nodes, x fastest; NaN for a node too far
// from tissue to have one: its edges cannot be severed.
using PlaceNodes = std::function<void(const Vec3i& brick, std::span<Vec3, kPlacedNodes> places)>;

// Whether the line of grid edges between the mid-planes of two neighbouring cells may be severed
// more than once. In moving tissue it may not (One): tissue between two such cuts would hold no
// particle to follow.
enum class CutsBetweenCells { Any, One };

// Severs the edges of `bricks` that the blade crosses and records its traces on their faces.
// Returns the number of edges newly severed.
std::int64_t severAlong(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                        std::span<const std::int64_t> bricks, const PlaceNodes& place,
                        CutsBetweenCells cuts = CutsBetweenCells::Any);

// The same for tissue at rest, in all bricks of the field where the blade can meet tissue.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade);

}  // namespace resect
