// Intersection of a ray with a triangle or a box.
#pragma once

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

// The points origin + t * direction with t >= 0. The direction may have any length but 0.
struct Ray {
  Vec3 origin, direction;
  Vec3 at(double t) const { return origin + t * direction; }
};

// A point of a surface and the unit normal there, which points out of the body. World, m.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();
};

// The t at which the ray meets the triangle a, b, c, from either side; infinity if it does not
// (Moeller and Trumbore 1997). Edges belong to the triangle, so no ray passes between two triangles
// of a closed surface. A ray that is parallel to the plane of the triangle, or lies in this plane,
// does not meet the triangle.
double firstMeeting(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

// Whether the ray meets the box; false for an empty box.
bool meets(const Ray& ray, const Aabb& box);

}  // namespace resect
