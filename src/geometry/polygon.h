// Triangulation of flat or nearly flat polygons.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// Triangulates a polygon. loop: the polygon's corners in order, as indices into `points`. Appends
// loop.size() - 2 triangles to `triangles`; they have the orientation of the polygon. Appends
// nothing if the polygon has fewer than three corners. A convex polygon becomes a fan of triangles
// round its first corner. Any other polygon is triangulated by ear clipping (Meisters 1975) in the
// plane perpendicular to its area vector. For n corners ear clipping takes O(n^3) at worst. If the
// polygon has no area or crosses itself, some of the triangles may overlap.
void triangulatePolygon(std::span<const Vec3> points, std::span<const std::int32_t> loop,
                        std::vector<Triangle>& triangles);

}  // namespace resect
