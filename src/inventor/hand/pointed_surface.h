// Finds the point of the organs that is seen at a pixel.
#pragma once

#include <Inventor/SbVec2s.h>

#include <optional>
#include <vector>

#include "inventor/gl/surface_ray.h"

class SbViewportRegion;

namespace resect {

class OperatingRoom;

class PointedSurface {
 public:
  explicit PointedSurface(OperatingRoom& room) : room_(room) {}

  // The nearest point that is seen at the pixel. It is on the present surface of an organ, or on
  // the plane of the table's top. The normal faces the camera. intoWounds: on a cut face, the
  // normal is not that of the face but leads half upwards and half to the camera, so that a blade
  // is not turned into the walls of a wound. Returns nothing if there is no such point within 5 m
  // of the camera.
  std::optional<SurfacePoint> under(const SbVec2s& pixel, const SbViewportRegion& viewport,
                                    bool intoWounds = false) const;

  // Call begin() when the instrument begins to press, at the point `first`. begin() copies the
  // surfaces of the organs. Until end() is called, along() finds points on these copies. (On the
  // surfaces themselves, an instrument that dents the tissue would follow its own dent down.)
  void begin(const SurfacePoint& first);
  void end();
  // The next point of the path along which the instrument presses. pixel: where the pointer is. Let
  // q be the point on the pixel's line of sight that has the depth of the last point. (Depth is
  // measured at right angles to the plane of the picture.) Let s be the point of an organ that is
  // seen at the pixel. The next point is s if s is near q, otherwise q. If there is no s, the next
  // point is q. s counts as near q if its distance from q is at most 20 mm, or at most twice the
  // distance from the last point to q. The first s of a path counts as near at any distance, so a
  // path may begin beside the organs. intoWounds: as for under(). Returns nothing if the last point
  // is behind the camera.
  std::optional<SurfacePoint> along(const SbVec2s& pixel, const SbViewportRegion& viewport,
                                    bool intoWounds = false);
  // True if the last call of along() was the first that found a point of an organ, and this point
  // is more than 20 mm from the point before. This occurs if a path begins beside the organs.
  bool landed() const { return landed_; }
  bool reached() const { return reached_; }  // whether the path has been on an organ

 private:
  Ray rayThrough(const SbVec2s& pixel, const SbViewportRegion& viewport) const;

  OperatingRoom& room_;
  std::vector<std::pair<SurfaceCopy, TriangleBlocks>> kept_;  // copies that begin() has made
  SurfacePoint last_;                                         // last point of the path
  bool reached_ = false;                                      // see reached()
  bool landed_ = false;
};

}  // namespace resect
