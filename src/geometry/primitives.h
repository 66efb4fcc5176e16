// Box, sphere and torus as closed meshes with outward normals.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// 8 points, 12 triangles. All three sides of `box` must be longer than 0.
TriangleMesh boxMesh(const Aabb& box);

// Sphere of `radius` > 0, m, with its poles along Y. `rings` >= 2: number of bands from pole to
// pole. Each band consists of 2 * rings quads. The two bands at the poles consist of 2 * rings
// triangles instead.
TriangleMesh sphereMesh(const Vec3& centre, double radius, int rings = 24);

// Torus whose axis is parallel to Y. `ring`: radius of the circle in the middle of the tube, m;
// `tube`: radius of the tube, m; ring > tube > 0. The surface has `around` quads round the axis and
// `across` quads round the tube; both >= 3.
TriangleMesh torusMesh(const Vec3& centre, double ring, double tube, int around = 48,
                       int across = 24);

}  // namespace resect
