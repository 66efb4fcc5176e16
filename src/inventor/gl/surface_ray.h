// Finds the point at which a ray first meets a surface.
#pragma once

#include <optional>

#include "geometry/ray.h"
#include "inventor/gl/triangle_blocks.h"
#include "surface/surface_update.h"

namespace resect {

// A point of an organ's surface. cut: its cut share, 0 on the capsule to 1 on a cut face.
struct OrganPoint : SurfacePoint {
  double cut = 0;
};

// The point at which the ray first meets the surface. Returns nothing if the ray does not meet the
// surface. blocks: the blocks of this surface, after TriangleBlocks::refresh(). Cost: a test of
// each block's box (one per 128 triangles), and a test of each triangle in the boxes that the ray
// meets.
std::optional<OrganPoint> firstPointOn(const SurfaceCopy& surface, const TriangleBlocks& blocks,
                                       const Ray& ray);

}  // namespace resect
