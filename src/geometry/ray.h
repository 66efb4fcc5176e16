// Where does a ray meet a triangle or a box?
#pragma once

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

// The points origin + t * direction with t >= 0. The direction may have any length but 0.
struct Ray {
  Vec3 origin, direction;
  Vec3 at(double t) const { return origin + t * direction; }
};

// t where it first meets the triangle a, b, c, from either side; infinity when it does not. Edges
// belong to the triangle, so that no ray slips through between two of a closed surface (Moeller and
// Trumbore 1997). A ray in the triangle's plane meets nothing.
double firstMeeting(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

// Has it a point in common with the box? Not with an empty one.
bool meets(const Ray& ray, const Aabb& box);

}  // namespace resect
