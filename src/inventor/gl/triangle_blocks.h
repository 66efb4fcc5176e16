// Finds the triangles of a large, changing surface that can be seen in a part of the picture, or
// that a ray can meet.
//
// The triangles are divided into blocks of 128 consecutive ones. For each block its bounding box
// and the range of its vertices are stored. A query tests every box and returns only the blocks
// that can matter. For a part of a few pixels it returns few blocks, however large the surface is.
// Only changed blocks are updated.
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

  // An entry (a, b, c, d) stands for the half space a * x + b * y + c * z + d >= 0.
  using HalfSpaces = std::array<Eigen::Vector4f, 6>;
  // Consecutive triangles. The last run can end beyond the last triangle.
  struct Run {
    std::size_t first = 0, count = 0;  // number of the first triangle; how many
  };
  struct Box {
    Vec3f low, high;  // low > high: empty
    bool empty() const { return low.x() > high.x(); }
    void grow(const Vec3f& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
  };
  static Box emptyBox();

  // To be called when the vertices or the triangles [begin, end) have changed. The next refresh()
  // then updates their blocks.
  void verticesChanged(std::size_t begin, std::size_t end) { vertices_.push_back({begin, end}); }
  void trianglesChanged(std::size_t begin, std::size_t end) { triangles_.push_back({begin, end}); }
  // Updates the blocks that use changed entries. A triangle whose first two corners are equal is an
  // unused element of the array, and is left out of its block's box.
  void refresh(std::span<const Vec3f> points, std::span<const Triangle> triangles);

  // After refresh(): bounds of the triangles that use any of the vertices [begin, end).
  Box around(std::size_t begin, std::size_t end, std::span<const Vec3f> points,
             std::span<const Triangle> triangles) const;
  // After refresh(): bounds of all triangles.
  Box box() const;
  // After refresh(): bounds of the triangles of each block.
  std::size_t blockCount() const { return blocks_.size(); }
  const Box& boxOf(std::size_t block) const { return blocks_[block].box; }
  // After refresh(): runs, in ascending order. They include every triangle that has a point which
  // lies in all half spaces at once.
  std::vector<Run> within(const HalfSpaces& spaces) const;
  // After refresh(): runs, in ascending order. They include every triangle that the ray meets.
  std::vector<Run> along(const Ray& ray) const;

 private:
  struct Block {
    Box box = emptyBox();
    std::int32_t low = 0, high = -1;  // lowest and highest vertex index; high -1: no triangle
    bool stale = true;                // must be updated by the next refresh()
  };
  template <typename Wanted>
  std::vector<Run> runsOf(Wanted wanted) const;
  struct Range {
    std::size_t begin, end;
  };
  std::vector<Block> blocks_;
  std::vector<Range> vertices_, triangles_;
};

// The half spaces whose intersection is the view volume of a part of the picture. `low`, `high`:
// lower left and upper right corner of the part; the picture extends from (-1, -1) to (1, 1).
// `matrix`: from object space to clip space, for row vectors.
TriangleBlocks::HalfSpaces halfSpacesOf(const float matrix[4][4], const Eigen::Vector2f& low,
                                        const Eigen::Vector2f& high);

}  // namespace resect
