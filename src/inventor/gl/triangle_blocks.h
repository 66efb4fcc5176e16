// Finds the triangles of a large, changing surface that can lie in a part of the picture or on a
// ray.
//
// Divides the triangles into blocks of 128 consecutive ones, each with its box and its range of
// vertices, so that a few pixels cost a few blocks, whatever the size of the surface. Only changed
// blocks are updated.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/ray.h"
#include "geometry/triangle_mesh.h"

namespace resect {

class TriangleBlocks {
 public:
  static constexpr std::size_t kTriangles = 128;  // of a block

  // Half spaces a * x + b * y + c * z + d >= 0.
  using HalfSpaces = std::array<Eigen::Vector4f, 6>;
  struct Run {
    std::size_t first = 0, count = 0;  // triangles
  };
  struct Box {
    Vec3f low, high;  // low > high: empty
    bool empty() const { return low.x() > high.x(); }
    void grow(const Vec3f& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
  };
  static Box emptyBox();

  // Elements [begin, end) have changed since the last refresh().
  void verticesChanged(std::size_t begin, std::size_t end) { vertices_.push_back({begin, end}); }
  void trianglesChanged(std::size_t begin, std::size_t end) { triangles_.push_back({begin, end}); }
  // Updates the blocks that use changed elements. Triangles with two equal corners count as holes.
  void refresh(std::span<const Vec3f> points, std::span<const Triangle> triangles);

  // After refresh(): bounds of the triangles that use any of the vertices [begin, end).
  Box around(std::size_t begin, std::size_t end, std::span<const Vec3f> points,
             std::span<const Triangle> triangles) const;
  // After refresh(): bounds of all triangles; runs of triangles that may intersect all half spaces,
  // in order.
  Box box() const;
  std::vector<Run> within(const HalfSpaces& spaces) const;
  // The same for triangles that the ray may meet.
  std::vector<Run> along(const Ray& ray) const;

 private:
  struct Block {
    Box box = emptyBox();
    std::int32_t low = 0, high = -1;  // none used
    bool stale = true;
  };
  template <typename Wanted>
  std::vector<Run> runsOf(Wanted wanted) const;
  struct Range {
    std::size_t begin, end;
  };
  std::vector<Block> blocks_;
  std::vector<Range> vertices_, triangles_;
};

// The half spaces whose intersection is the view volume of the part [x0, x1] x [y0, y1] of the
// picture, in clip coordinates -1 to 1; matrix: row vectors to clip space.
TriangleBlocks::HalfSpaces halfSpacesOf(const float matrix[4][4], const Eigen::Vector2f& low,
                                        const Eigen::Vector2f& high);

}  // namespace resect
