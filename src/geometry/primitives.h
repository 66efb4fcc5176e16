// Box, sphere and torus as closed meshes with outward normals.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// 8 points, 12 triangles. All three sides of `box` must be longer than 0.
TriangleMesh boxMesh(const Aabb& box);

// Sphere of `radius` > 0, m, with its poles along Y. It has `rings` >= 2 bands between the poles,
// each of 2 * rings quads; at the poles the quads are triangles.
TriangleMesh sphereMesh(const Vec3& centre, double radius, int rings = 24);

// Torus whose axis is parallel to Y. Radii `ring` > `tube` > 0, m; number of quads `around` the
// axis and `across` the tube, each >= 3.
TriangleMesh torusMesh(const Vec3& centre, double ring, double tube, int around = 48,
                       int across = 24);

}  // namespace resect
