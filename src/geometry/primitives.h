// Box, sphere and torus as closed meshes with outward normals.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// 8 points, 12 triangles. Each side of `box` > 0.
TriangleMesh boxMesh(const Aabb& box);

// Sphere of `radius` > 0, m, as `rings` >= 2 bands of 2 * rings quads; poles on the Y axis.
TriangleMesh sphereMesh(const Vec3& centre, double radius, int rings = 24);

// Torus round the Y axis: ring radius > tube radius > 0, m.
TriangleMesh torusMesh(const Vec3& centre, double ring, double tube, int around = 48,
                       int across = 24);

}  // namespace resect
