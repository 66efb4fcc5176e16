// Shows on an organ's surface where a guided instrument works and towards what its edge faces: a
// ring at the point under the pointer, an arrow, and ticks on the ring's far side for the depth,
// one per 5 mm.
#pragma once

#include "base/vec.h"
#include "geometry/aabb.h"
#include "operation/hand/surface_hand.h"

class SoBaseColor;
class SoCoordinate3;
class SoLineSet;
class SoSeparator;
class SoSwitch;

namespace resect {

class AimMarker {
 public:
  explicit AimMarker(SoSeparator* parent);
  ~AimMarker();
  AimMarker(const AimMarker&) = delete;
  AimMarker& operator=(const AimMarker&) = delete;

  // Hides the marker if `hand` is null. Returns the box, world, m, of what has to be drawn again:
  // empty if nothing changed.
  Aabb show(const SurfaceHand* hand);

 private:
  SoSeparator* parent_;
  SoSwitch* root_;
  SoBaseColor* colour_;
  SoCoordinate3* corners_;
  SoLineSet* lines_;
  Aabb box_;  // of what is shown
  Vec3 at_ = Vec3::Zero(), heading_ = Vec3::Zero(), up_ = Vec3::Zero();
  double depth_ = 0;
  bool pressing_ = false;
};

}  // namespace resect
