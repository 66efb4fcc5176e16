// Collects the changes of an organ's surface for a viewer that takes them from time to time.
//
// follow() collects the changes of one step; take() returns all changes since the last take(). If
// the tissue moves, its vertices are published in blocks of 64. A block is published when one of
// its vertices has moved visibly since the block was last published. Rest positions and cut shares
// (isosurface/brick_look.h) are published only for new vertices. Cost of follow(): proportional to
// the changes. For moving tissue, there is also a pass over all vertices. One publisher serves one
// organ and one viewer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "operation/live/present_surface.h"
#include "surface/surface_update.h"

namespace resect {

class SurfacePublisher {
 public:
  static constexpr int kChunk = 64;            // vertices of a block
  static constexpr float kSeenMotion = 5e-5f;  // m: smaller motions are not visible

  // seenMotion, m: a block is published only if one of its vertices has moved farther than this
  // since the block was last published.
  explicit SurfacePublisher(float seenMotion = kSeenMotion) : seenMotion_(seenMotion) {}

  // Call after every step, since the surface keeps only the changes of the last step. In four cases
  // the next update is the whole surface:
  // - This is the first call.
  // - The surface's arrays were made anew.
  // - There was a step for which follow() was not called, as when an undo restores a state and
  //   plays frames.
  // - The collected changes have become larger than twice the surface.
  void follow(const PresentSurface& surface);

  // Returns the changes collected since the last call of take(). A viewer that applies all updates
  // in order has the present surface, except for motions that are too small to be published.
  SurfaceUpdate take();

 private:
  void followShape(const PresentSurface& surface);
  void tellEverything(const PresentSurface& surface);
  void findUnseen(std::span<const Vec3f> points, std::span<const IndexRange> changed);

  float seenMotion_;
  bool begun_ = false;
  bool heated_ = false;         // whether heat had changed tissue at the last follow()
  bool wet_ = false;            // whether there was blood at the last follow()
  std::uint64_t followed_ = 0;  // SurfaceTracker::Changes::number at the last follow()
  std::shared_ptr<const VesselPicture> vessels_;  // made only once
  SurfaceUpdate update_;
  std::vector<Vec3f> told_;           // for moving tissue: last published position of each vertex
  std::vector<std::uint8_t> unseen_;  // 1 for each block whose motion has not been taken yet
};

}  // namespace resect
