// Area, volume and centroid of a triangle mesh.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Sum of the triangles' areas, m^2.
double area(const TriangleMesh& mesh);

// Each triangle forms a tetrahedron with the origin. The result is the sum of the signed volumes of
// these tetrahedra, m^3. For a closed mesh the sum is the enclosed volume, and it is negative if
// the mesh is inside out. For an open mesh the sum depends on where the origin is.
double volume(const TriangleMesh& mesh);

// The same sum with the point `tip` in place of the origin. For a closed mesh the result does not
// depend on `tip`, but the rounding error is smaller if `tip` is near the mesh.
double volumeAbout(const TriangleMesh& mesh, const Vec3& tip);

// Centroid of the volume that a closed mesh encloses, m. If the mesh encloses no volume, the result
// is the centre of its bounding box.
Vec3 centroid(const TriangleMesh& mesh);

}  // namespace resect
