// Finds triangles of a large surface that changes: the triangles that can be seen in a part of the
// picture, or those that a ray can meet.
//
// The triangles are divided into blocks of 128 consecutive triangles. For each block its bounding
// box and the range of its vertices are stored. A query tests the boxes of all blocks, and returns
// only the blocks whose boxes may be seen in the part of the picture, or meet the ray. For a part
// of a few pixels these are few blocks, even if the surface is large. After a change only the
// changed blocks are updated.
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
  static constexpr std::size_t kTriangles = 128;  // number of triangles in a block

  // Six half spaces. The vector (a, b, c, d) stands for the half space
  // a * x + b * y + c * z + d >= 0.
  using HalfSpaces = std::array<Eigen::Vector4f, 6>;
  // A number of consecutive triangles. The last run of a result can extend beyond the last
  // triangle.
  struct Run {
    // Index of the first triangle, and number of triangles.
    std::size_t first = 0, count = 0;
  };
  struct Box {
    Vec3f low, high;  // lowest and highest coordinates; the box is empty if low > high
    bool empty() const { return low.x() > high.x(); }
    void grow(const Vec3f& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
  };
  static Box emptyBox();

  // Call these functions when vertices or triangles have changed: those with the indices `begin` to
  // end - 1. The next refresh() then updates the blocks of these vertices or triangles.
  void verticesChanged(std::size_t begin, std::size_t end) { vertices_.push_back({begin, end}); }
  void trianglesChanged(std::size_t begin, std::size_t end) { triangles_.push_back({begin, end}); }
  // Updates the blocks that contain changed triangles or use changed vertices. A triangle whose
  // first two corners are equal is an unused element of the array. The boxes of the blocks do not
  // include such triangles.
  void refresh(std::span<const Vec3f> points, std::span<const Triangle> triangles);

  // Call this only after refresh(). Bounds of all triangles that use at least one of the vertices
  // `begin` to end - 1.
  Box around(std::size_t begin, std::size_t end, std::span<const Vec3f> points,
             std::span<const Triangle> triangles) const;
  // Call this only after refresh(). Bounds of all triangles.
  Box box() const;
  // Call these only after refresh(). The number of blocks, and the bounds of the triangles of a
  // block.
  std::size_t blockCount() const { return blocks_.size(); }
  const Box& boxOf(std::size_t block) const { return blocks_[block].box; }
  // Call this only after refresh(). Runs in ascending order. They include every triangle that has a
  // point in the intersection of the half spaces.
  std::vector<Run> within(const HalfSpaces& spaces) const;
  // Call this only after refresh(). Runs in ascending order. They include every triangle that the
  // ray meets.
  std::vector<Run> along(const Ray& ray) const;

 private:
  struct Block {
    Box box = emptyBox();
    // Lowest and highest index of a vertex of the block. If `high` is -1, the block has no
    // triangle.
    std::int32_t low = 0, high = -1;
    bool stale = true;  // the next refresh() must update the block
  };
  template <typename Wanted>
  std::vector<Run> runsOf(Wanted wanted) const;
  struct Range {
    std::size_t begin, end;
  };
  std::vector<Block> blocks_;
  std::vector<Range> vertices_, triangles_;
};

// The half spaces whose intersection is the view volume of a part of the picture. matrix: converts
// row vectors from object space to clip space. low, high: lower left and upper right corners of the
// part; the whole picture extends from (-1, -1) to (1, 1).
TriangleBlocks::HalfSpaces halfSpacesOf(const float matrix[4][4], const Eigen::Vector2f& low,
                                        const Eigen::Vector2f& high);

}  // namespace resect
