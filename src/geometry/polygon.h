// Triangulation of flat or nearly flat polygons.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// Appends loop.size() - 2 triangles with the corners `loop` (indices into points, in order; with
// the loop's orientation) to `triangles`. A convex polygon becomes a fan round its first corner,
// any other is triangulated by ear clipping in the plane perpendicular to its area vector
// (Meisters 1975), O(n^3) at worst. Fewer than three corners give nothing; a polygon without area
// or one that crosses itself is still covered by that many triangles, some of which may overlap.
void triangulatePolygon(std::span<const Vec3> points, std::span<const std::int32_t> loop,
                        std::vector<Triangle>& triangles);

}  // namespace resect
