// Triangle meshes. A mesh consists of points, and of triangles whose corners are these points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

// Indices of the three corners, counter-clockwise as seen from outside.
using Triangle = std::array<std::int32_t, 3>;

struct TriangleMesh {
  std::vector<Vec3> points;         // m
  std::vector<Triangle> triangles;  // indices into points

  template <class Visitor>
  void visit(Visitor& v) {
    v("points", points), v("triangles", triangles);
  }
};

Aabb bounds(const TriangleMesh& mesh);

// Throws Error if a triangle refers to a point that does not exist. Cost: a pass over the
// triangles.
void requireTriangles(const TriangleMesh& mesh);
// Does the same as requireTriangles(), and also throws Error if a point is not finite.
void requireSound(const TriangleMesh& mesh);

// The mesh with all its points transformed by the pose.
TriangleMesh transformed(TriangleMesh mesh, const Pose& pose);

// Appends the points and triangles of b to a.
void append(TriangleMesh& a, const TriangleMesh& b);

// Reverses the orientation of every triangle.
void flip(TriangleMesh& mesh);

}  // namespace resect
