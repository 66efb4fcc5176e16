// Box, sphere and torus as closed meshes with outward normals.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// A box with 8 points and 12 triangles. All three sides of `box` must be longer than 0.
TriangleMesh boxMesh(const Aabb& box);

// A sphere whose poles lie along Y. radius: > 0, m. rings: number of bands from pole to pole, at
// least 2. The first and the last band touch the poles, and consist of 2 * rings triangles each.
// All bands between them consist of 2 * rings quads each, and a quad is two triangles.
TriangleMesh sphereMesh(const Vec3& centre, double radius, int rings = 24);

// A torus whose axis is parallel to Y. ring: radius of the circle in the middle of the tube, m.
// tube: radius of the tube, m. The function requires ring > tube > 0. around: number of quads round
// the axis, >= 3. across: number of quads round the tube, >= 3.
TriangleMesh torusMesh(const Vec3& centre, double ring, double tube, int around = 48,
                       int across = 24);

}  // namespace resect
