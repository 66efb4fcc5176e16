// Intersection of a ray with a triangle or a box.
#pragma once

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

// The points origin + t * direction for all t >= 0. `direction` may have any length except 0.
struct Ray {
  Vec3 origin, direction;
  Vec3 at(double t) const { return origin + t * direction; }
};

// A point of a surface, and the surface's unit normal at this point. The normal points out of the
// body. Coordinates are in the world, m.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();
};

// The value t for which the point origin + t * direction of the ray lies on the triangle with the
// corners a, b and c (Moeller and Trumbore 1997). The ray may come from either side of the
// triangle. Returns infinity if the ray does not meet the triangle. The edges belong to the
// triangle, so no ray passes between two triangles of a closed surface. A ray that is parallel to
// the triangle's plane, or lies in this plane, counts as not meeting the triangle.
double firstMeeting(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

// Whether the ray meets the box. False if the box is empty.
bool meets(const Ray& ray, const Aabb& box);

}  // namespace resect
