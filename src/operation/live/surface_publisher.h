// What must somebody be told of an organ's surface who looks now and then?
//
// Follows the surface step by step and gathers what has changed until it is taken. Of tissue that
// moves that is, in chunks of 64 vertices, what has moved far enough to be seen since it was told
// last; rest places and shares of cut go with new vertices only. Cost of a step: its changes, and
// for tissue that moves a look at each vertex. One publisher per organ and viewer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "operation/live/present_surface.h"
#include "surface/surface_update.h"

namespace resect {

class SurfacePublisher {
 public:
  static constexpr int kChunk = 64;            // vertices of moving tissue that are told together
  static constexpr float kSeenMotion = 5e-5f;  // m: an eye takes what moved less to be still

  // Vertices that moved by no more than this since they were told last are passed over, m.
  explicit SurfacePublisher(float seenMotion = kSeenMotion) : seenMotion_(seenMotion) {}

  // After every step, for the changes of the surface are those of the last one. The first makes an
  // update of everything; so does one after which the update would be larger than the surface.
  void follow(const PresentSurface& surface);

  // Moves out all that has changed since the last call. Whoever applies all updates in their order
  // holds the surface, to within the motion that is passed over.
  SurfaceUpdate take();

 private:
  void tellEverything(const PresentSurface& surface);
  void findUnseen(std::span<const Vec3f> points, std::span<const IndexRange> changed);

  float seenMotion_;
  bool begun_ = false;
  SurfaceUpdate update_;
  std::vector<Vec3f> told_;           // of moving tissue: where each vertex was last said to be
  std::vector<std::uint8_t> unseen_;  // 1 for each chunk of these that has not been taken yet
};

}  // namespace resect
