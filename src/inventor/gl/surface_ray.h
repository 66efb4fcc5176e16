// The point at which a ray first meets a surface in blocks of triangles.
#pragma once

#include <optional>

#include "geometry/ray.h"
#include "inventor/gl/triangle_blocks.h"
#include "surface/surface_update.h"

namespace resect {

// None if the ray does not meet the surface. The blocks must be those of the surface, refreshed.
// Cost: a box test per 128 triangles, and a test of each triangle in the boxes that the ray meets.
std::optional<SurfacePoint> firstPointOn(const SurfaceCopy& surface, const TriangleBlocks& blocks,
                                         const Ray& ray);

}  // namespace resect
