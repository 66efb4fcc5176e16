// Orbit, pan and zoom of the camera about a point of interest.
//
//   right button, dragged                      orbit
//   left button, dragged                       orbit
//   middle button, or Shift and any button     pan
//   wheel                                      zoom; the point under the pointer stays in place
//
// An event moves the camera only if nothing else has used the event.
//
// The camera stays upright. Its elevation is limited, so it cannot turn upside down.
#pragma once

#include <Inventor/SbVec2s.h>
#include <Inventor/SbViewVolume.h>

#include <functional>
#include <optional>

#include "base/vec.h"

class SbViewportRegion;
class SoEvent;
class SoPerspectiveCamera;

namespace resect {

// The view volume of the camera for a picture of the size of `viewport`. The picture may be higher
// than it is wide.
SbViewVolume viewVolumeOf(const SoPerspectiveCamera& camera, const SbViewportRegion& viewport);

class CameraMoves {
 public:
  explicit CameraMoves(SoPerspectiveCamera* camera) : camera_(camera) {}

  // Handles an event. Call it only for events that nothing else has used. Returns true if the event
  // belongs to a drag or to the wheel, even if the camera did not move.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);
  // Whether the user is dragging the camera.
  bool dragging() const { return drag_ != Drag::None; }

  // Moves the camera round the point of interest. The scene seems to turn to the right by the angle
  // `right` and upwards by the angle `up`, rad.
  void orbit(double right, double up);
  // Least angle of the camera over the horizontal plane through the point of interest, rad. orbit()
  // does not move the camera below this angle.
  double lowest = -0.2;
  // Moves the camera parallel to the plane of the picture. The scene seems to move to the right by
  // the distance `right` and upwards by the distance `up`, m.
  void pan(double right, double up);
  // Multiplies the camera's distance from the point of interest by `factor`. The new distance is
  // limited to 0.05 to 10 m.
  void zoom(double factor);
  // Multiplies the camera's distance from a point by `factor`. The camera moves along the line to
  // the point, so the point stays where it is in the picture. The camera's distance from the point
  // of interest changes by the same factor, and is limited as in zoom().
  void zoomAt(const Vec3& point, double factor);
  // Turns the camera towards a point. This point becomes the point of interest.
  void lookAt(const Vec3& point);
  Vec3 pointOfInterest() const;

  // Returns the point that is seen at a pixel. The wheel zooms to this point. There are three
  // exceptions: this function is not set, it returns no point, or the point is more than twice as
  // far from the camera as the point of interest. In these cases the wheel zooms to the point on
  // the pixel's line of sight that has the depth of the point of interest.
  std::function<std::optional<Vec3>(const SbVec2s& pixel, const SbViewportRegion&)> pointUnder;

 private:
  double metresPerPixel(const SbViewportRegion& viewport) const;
  void zoomToPointer(const SbVec2s& at, const SbViewportRegion& viewport, double factor);
  enum class Drag { None, Orbit, Pan };
  SoPerspectiveCamera* camera_;
  Drag drag_ = Drag::None;
  int button_ = 0;
  SbVec2s lastAt_;
};

}  // namespace resect
