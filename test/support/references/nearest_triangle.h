// Nearest triangle of a mesh to a point, with a uniform grid.
#pragma once

#include <vector>

#include "geometry/aabb.h"
#include "geometry/triangle_mesh.h"

namespace resect::test {

class NearestTriangle {
 public:
  // The mesh must outlive this object and have a triangle. cell > 0: side of a grid cell, m; about
  // an edge of the mesh.
  NearestTriangle(const TriangleMesh& mesh, double cell);

  struct Result {
    double distance;        // m
    std::int32_t triangle;  // among equals the first
  };
  // Exact. Cost: the cells between the point and the mesh.
  Result operator()(const Vec3& point) const;

 private:
  Vec3i cellOf(const Vec3& point) const;

  const TriangleMesh& mesh_;
  double cell_;
  Aabb box_;
  Vec3i dims_;
  std::vector<std::vector<std::int32_t>> triangles_;  // per cell: those whose box meets it
};

// How far is a surface from the one that it stands for? Means over the surface, by area.
struct Deviation {
  double distance = 0;      // of its triangles' centroids to the original's nearest triangle, m
  double faceAngle = 0;     // between its triangles' normals and that triangle's, degrees
  double shadingAngle = 0;  // between its vertex normals and the nearest triangle's, degrees
};

// `normals`: unit, one per point of the surface.
Deviation deviation(const TriangleMesh& surface, const std::vector<Vec3f>& normals,
                    const TriangleMesh& original);

}  // namespace resect::test
