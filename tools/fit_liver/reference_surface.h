// Signed distance of a point to the measured liver.
//
// Exact distance to the triangles through a tree of boxes; side by counting the triangles above
// the point. Built once for a closed mesh; a query costs some microseconds.
#pragma once

#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace fit_liver {

// Triangles of a Wavefront file (v and f lines only), m.
resect::TriangleMesh readObj(const std::string& path);

class ReferenceSurface {
 public:
  explicit ReferenceSurface(resect::TriangleMesh mesh);

  const resect::TriangleMesh& mesh() const { return mesh_; }
  bool inside(const resect::Vec3& p) const;
  // Negative inside, m.
  double signedDistance(const resect::Vec3& p) const;

 private:
  struct Node {
    resect::Aabb box;
    int begin, end;  // range of order_
    int left = -1, right = -1;
  };
  int build(int begin, int end);
  void nearest(int node, const resect::Vec3& p, double& best) const;

  resect::TriangleMesh mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
  resect::Aabb box_;
  std::vector<std::vector<int>> columns_;  // triangles over each cell of the x, z plane
};

}  // namespace fit_liver
