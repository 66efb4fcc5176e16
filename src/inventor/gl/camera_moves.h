// Orbit, pan and zoom of the camera about a point of interest.
//
//   right button, dragged                      orbit
//   left button, dragged                       orbit, if nothing else has used the event
//   middle button, or Shift and any button     pan
//   wheel                                      zoom; the point under the pointer stays there
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

// The view volume of the camera for a picture of the size of `viewport`, which may be higher than
// it is wide.
SbViewVolume viewVolumeOf(const SoPerspectiveCamera& camera, const SbViewportRegion& viewport);

class CameraMoves {
 public:
  explicit CameraMoves(SoPerspectiveCamera* camera) : camera_(camera) {}

  // Handles an event that nothing else has used. Returns true if the event belongs to a drag or to
  // the wheel, even if the camera did not move.
  bool handle(const SoEvent& event, const SbViewportRegion& viewport);
  bool dragging() const { return drag_ != Drag::None; }  // a drag moves the camera

  // Moves the camera round the point of interest, so that the scene seems to turn to the right and
  // upwards by these angles, rad.
  void orbit(double right, double up);
  double lowest =
      -0.2;  // rad: height of the camera over the horizon below which orbit() does not go
  // Moves the camera in its view plane, so that the scene seems to move to the right and upwards by
  // these distances, m.
  void pan(double right, double up);
  // Multiplies the camera's distance from the point of interest by `factor`. The new distance is
  // kept within 0.05 to 10 m.
  void zoom(double factor);
  // Brings the camera nearer to a point by `factor`, in a straight line: the point stays where it
  // is in the picture. The distance to the point of interest is limited as by zoom().
  void zoomAt(const Vec3& point, double factor);
  // Turns the camera towards a point, which becomes the point of interest.
  void lookAt(const Vec3& point);
  Vec3 pointOfInterest() const;

  // Gives the point that is seen at a pixel; the wheel zooms to this point. If the function is not
  // set or gives no point, or if the point is more than twice as far from the camera as the point
  // of interest, the wheel zooms to the point of the pixel's line of sight that is at the same
  // depth as the point of interest.
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
