// Collects the changes of an organ's surface for a viewer that takes them from time to time.
//
// Follows the surface step by step and collects changes until they are taken. For moving tissue
// these are blocks of 64 vertices in which one has moved visibly since it was last published; rest
// positions and cut shares are sent with new vertices only. Cost of a step: its changes, and for
// moving tissue a pass over the vertices. One publisher per organ and viewer.
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

  // Vertices that moved by no more than this since they were last published are left out, m.
  explicit SurfacePublisher(float seenMotion = kSeenMotion) : seenMotion_(seenMotion) {}

  // Call after every step, since the surface keeps only the last step's changes. The first call
  // makes an update of everything; so does one after which the update would be larger than the
  // surface.
  void follow(const PresentSurface& surface);

  // Returns all changes since the last call. A viewer that applies all updates in order has the
  // surface, up to the motion that is left out.
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
