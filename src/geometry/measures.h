// Area, volume and centroid of a triangle mesh.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Sum of the triangles' areas, m^2.
double area(const TriangleMesh& mesh);

// Signed sum of the volumes of the tetrahedra between each triangle and the origin, m^3. For a
// closed mesh this is the enclosed volume, negative if the mesh is inside out. For an open mesh it
// depends on where the origin is.
double volume(const TriangleMesh& mesh);

// The same with `tip` in place of the origin. A closed mesh has the same volume for any tip; a tip
// near the mesh gives less rounding error.
double volumeAbout(const TriangleMesh& mesh, const Vec3& tip);

// Centroid of the volume that a closed mesh encloses, m. If it encloses nothing: the centre of its
// bounding box.
Vec3 centroid(const TriangleMesh& mesh);

}  // namespace resect
