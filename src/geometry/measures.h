// Area, volume and centroid of a triangle mesh.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Sum of the triangles' areas, m^2.
double area(const TriangleMesh& mesh);

// Signed sum of the tetrahedra that the triangles make with the origin, m^3: the enclosed volume of
// a closed mesh that is oriented outwards, its negative for one inside out; for an open mesh a
// number that depends on where the origin is.
double volume(const TriangleMesh& mesh);

// The same with tetrahedra to `tip` instead of the origin: the same number for a closed mesh, with
// less rounding when the mesh lies far from the origin and near the tip.
double volumeAbout(const TriangleMesh& mesh, const Vec3& tip);

// Volume centroid of a closed mesh, m; centre of the bounding box when it encloses nothing.
Vec3 centroid(const TriangleMesh& mesh);

}  // namespace resect
