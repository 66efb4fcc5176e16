// Triangulation of flat or nearly flat polygons.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// Appends to `triangles` the loop.size() - 2 triangles of a polygon, with the polygon's
// orientation. `loop`: its corners in order, as indices into `points`. A convex polygon becomes a
// fan round its first corner. Any other is triangulated by ear clipping (Meisters 1975) in the
// plane perpendicular to its area vector, O(n^3) at worst. Fewer than three corners give nothing. A
// polygon without area, or one that crosses itself, gives as many triangles, but some may overlap.
void triangulatePolygon(std::span<const Vec3> points, std::span<const std::int32_t> loop,
                        std::vector<Triangle>& triangles);

}  // namespace resect
