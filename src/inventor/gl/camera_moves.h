// How does a person look round the operating room? Orbit, pan and zoom about a point of interest.
//
// Right button drag: orbit; with Shift: pan. Left button drag: orbit, when nothing else wants it.
// Middle button drag: pan. Wheel: zoom towards the point of interest. The camera stays upright and
// above the floor of its own sphere, so it cannot get lost upside down.
#pragma once

#include <Inventor/SbVec2s.h>
#include <Inventor/SbViewVolume.h>

#include "base/vec.h"

class SbViewportRegion;
class SoEvent;
class SoPerspectiveCamera;

namespace resect {

// What the camera sees in a picture of this size: as it is drawn, also in pictures higher than
// wide.
SbViewVolume viewVolumeOf(const SoPerspectiveCamera& camera, const SbViewportRegion& viewport);

class CameraMoves {
 public:
  explicit CameraMoves(SoPerspectiveCamera* camera) : camera_(camera) {}

  // An event that nobody else wanted; true when the camera took it.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Angles in rad, about the point of interest: to the right and upwards.
  void orbit(double right, double up);
  // Metres in the view plane.
  void pan(double right, double up);
  // Distance to the point of interest is multiplied, within 5 cm to 10 m.
  void zoom(double factor);
  // Turns towards a point, which becomes the point of interest.
  void lookAt(const Vec3& point);
  Vec3 pointOfInterest() const;

 private:
  enum class Drag { None, Orbit, Pan };
  SoPerspectiveCamera* camera_;
  Drag drag_ = Drag::None;
  int button_ = 0;
  SbVec2s lastAt_;
};

}  // namespace resect
