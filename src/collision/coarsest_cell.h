// The largest cells that an organ should be made of, from the shape of its surface alone.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

inline constexpr double kMostLostTissue = 0.02;   // largest lost share of the tissue's volume
inline constexpr double kFewestParticles = 2000;  // of a whole organ; fewer do not show its shape

// Side, m, of the largest cubic cells that lose no more than kMostLostTissue of the tissue
// (WallThickness::lostAt()) and make at least kFewestParticles particles. The side is a multiple of
// 0.01 mm, from 0.01 to 100 mm. The mesh must be closed and oriented outwards. Cost: that of
// wallThickness().
double coarsestCell(const TriangleMesh& surface);

}  // namespace resect
