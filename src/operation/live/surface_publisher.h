// Collects the changes of an organ's surface for a viewer that takes them from time to time.
//
// Follows the surface step by step and collects changes until they are taken. Moving tissue is
// published in blocks of 64 vertices: a block is sent when one of its vertices has moved visibly
// since the block was last published. Rest positions and cut shares are sent with new vertices
// only. Cost of a step: proportional to its changes, and for moving tissue a pass over the
// vertices. One publisher serves one organ and one viewer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "operation/live/present_surface.h"
#include "surface/surface_update.h"

namespace resect {

class SurfacePublisher {
 public:
  static constexpr int kChunk = 64;  // vertices of moving tissue that are published together
  static constexpr float kSeenMotion = 5e-5f;  // m: smaller motions are not visible

  // seenMotion: a block is left out as long as none of its vertices has moved farther than this
  // since the block was last published, m.
  explicit SurfacePublisher(float seenMotion = kSeenMotion) : seenMotion_(seenMotion) {}

  // Call after every step, since the surface keeps only the last step's changes. The next update is
  // the whole surface after the first call, after the surface's arrays were made anew, or if the
  // collected changes exceed twice the surface.
  void follow(const PresentSurface& surface);

  // Returns all changes since the last call. A viewer that applies all updates in order has the
  // surface, except for motions that were left out as too small.
  SurfaceUpdate take();

 private:
  void tellEverything(const PresentSurface& surface);
  void findUnseen(std::span<const Vec3f> points, std::span<const IndexRange> changed);

  float seenMotion_;
  bool begun_ = false;
  SurfaceUpdate update_;
  std::vector<Vec3f> told_;           // for moving tissue: last published position of each vertex
  std::vector<std::uint8_t> unseen_;  // 1 for each block whose motion has not been taken yet
};

}  // namespace resect
