// Area, volume and centroid of a triangle mesh.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Sum of the triangles' areas, m^2.
double area(const TriangleMesh& mesh);

// The sum of the signed volumes of the tetrahedra that the triangles make with the origin, m^3. For
// a closed mesh this is the enclosed volume; it is negative if the mesh is inside out. For an open
// mesh it depends on where the origin is.
double volume(const TriangleMesh& mesh);

// volume() with the point `tip` in place of the origin. A closed mesh has the same volume for any
// tip; a tip near the mesh gives less rounding error.
double volumeAbout(const TriangleMesh& mesh, const Vec3& tip);

// Centroid of the volume that a closed mesh encloses, m. If the mesh encloses no volume: the centre
// of its bounding box.
Vec3 centroid(const TriangleMesh& mesh);

}  // namespace resect
