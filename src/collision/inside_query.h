// Is this one point inside a closed body? For those who ask point by point.
//
// Answers exactly what insideFlags (collision/inside.h) answers, bit for bit: the column through
// the point itself is tested against the few triangles of its cell in a grid over x and y. Cost: a
// pass over the mesh to build, a handful of triangles per question.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/columns.h"

namespace resect {

class InsideQuery {
 public:
  // Answers for points in `region` only. The mesh is closed, oriented and looks outwards.
  InsideQuery(std::shared_ptr<const TriangleMesh> mesh, const Aabb& region);

  // False outside the region and the mesh's box.
  bool isInside(const Vec3& p) const;

  const SnappedMesh& snapped() const { return snapped_; }

 private:
  int cellX(std::int32_t x) const;
  int cellY(std::int32_t y) const;

  std::shared_ptr<const TriangleMesh> mesh_;
  SnappedMesh snapped_;
  Aabb region_;
  std::int32_t originX_ = 0, originY_ = 0;
  std::int64_t width_ = 1, height_ = 1;  // of a cell, raster steps
  int side_ = 1;                         // cells along x and y
  std::vector<std::uint32_t> offsets_, triangles_;
};

}  // namespace resect
