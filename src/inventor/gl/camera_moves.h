// Orbit, pan and zoom of the camera about a point of interest.
//
// Drag with the right button: orbit. With the left button: the same, if nothing else uses it. With
// the middle button, or with Shift and any button: pan. Wheel: zoom towards the point of interest.
// The camera stays upright, and its elevation is limited, so it cannot turn upside down.
#pragma once

#include <Inventor/SbVec2s.h>
#include <Inventor/SbViewVolume.h>

#include "base/vec.h"

class SbViewportRegion;
class SoEvent;
class SoPerspectiveCamera;

namespace resect {

// The view volume of the camera for a picture of this size, which may be higher than wide.
SbViewVolume viewVolumeOf(const SoPerspectiveCamera& camera, const SbViewportRegion& viewport);

class CameraMoves {
 public:
  explicit CameraMoves(SoPerspectiveCamera* camera) : camera_(camera) {}

  // Handles an event that nothing else has handled; true if it moved the camera.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);

  // Moves the camera round the point of interest, so that the scene seems to turn by these angles,
  // rad, to the right and upwards.
  void orbit(double right, double up);
  // Moves the camera, so that the scene seems to move in the view plane, m.
  void pan(double right, double up);
  // Multiplies the distance to the point of interest, and keeps it within 5 cm to 10 m.
  void zoom(double factor);
  // Turns the camera towards a point, which becomes the point of interest.
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
