// Computes the side of the largest cells that an organ should be made of. Only the shape of the
// organ's surface is used.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Largest share of the tissue's volume that may be lost when the organ is made of cells.
inline constexpr double kMostLostTissue = 0.02;
// Least number of particles of a whole organ. Fewer particles do not show the organ's shape.
inline constexpr double kFewestParticles = 2000;

// Side, m, of the largest cubic cells that meet two conditions: the share of lost tissue
// (WallThickness::lostAt() in collision/wall_thickness.h) is at most kMostLostTissue, and the organ
// has at least kFewestParticles particles. The side is a multiple of 0.01 mm, from 0.01 to 100 mm.
// The mesh must be closed and oriented outwards. The cost is that of wallThickness().
double coarsestCell(const TriangleMesh& surface);
// The same, but only with the second condition, at the cost of a pass over the triangles.
double coarsestCellOfMany(const TriangleMesh& surface);

}  // namespace resect
