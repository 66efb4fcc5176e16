// Which grid edges does a blade sever on its way from one pose to the next, and where does it leave
// its trace on the grid's faces?
//
// The grid moves with the tissue: its nodes are placed in the world, then the edges between them
// are tested against the sweep's triangles exactly as bonds between particles are (closed
// intervals, a point on the plane counts as above: collision/swept_blade.h), so that nothing slips
// through. What is found is kept in rest space. Cost: some microseconds per brick and triangle that
// meet.
#pragma once

#include <functional>
#include <span>

#include "collision/swept_blade.h"
#include "sph/colour_field.h"
#include "wound/severed_edges.h"

namespace resect {

constexpr int kPlacedNodes = 125;  // the 5 x 5 x 5 nodes on which a brick's edges and faces lie
// Writes the present places (world, m) of a brick's nodes, x fastest; NaN for a node that lies too
// far from tissue to have one: its edges cannot be severed.
using PlaceNodes = std::function<void(const Vec3i& brick, std::span<Vec3, kPlacedNodes> places)>;

// Bonds between particles are cut once; what a second blade would cut off between two particles'
// planes holds none, and would follow nobody. So in tissue that moves a way from the middle plane
// of one cell to that of the next is severed at one place at most.
enum class CutsBetweenCells { Any, One };

// Severs the edges and traces the faces of `bricks` that the blade crosses. Returns the number of
// edges that were whole before.
std::int64_t severAlong(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                        std::span<const std::int64_t> bricks, const PlaceNodes& place,
                        CutsBetweenCells cuts = CutsBetweenCells::Any);

// The same in tissue at rest: all bricks of the field in which the blade can meet tissue or skin.
std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade);

}  // namespace resect
