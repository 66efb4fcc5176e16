// The point of the organs that is seen under a pixel.
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

  // The nearest point under the pixel on an organ's present surface or on the plane of the table's
  // top. None if there is no such point within 5 m of the camera. The normal faces the camera.
  std::optional<SurfacePoint> under(const SbVec2s& pixel, const SbViewportRegion& viewport) const;

  // To be called when a stroke begins at `first`. Until end(), along() finds points on copies of
  // the organs' surfaces as they are at the call of begin(). On the moving surfaces an instrument
  // that dents the tissue would follow its own dent down.
  void begin(const SurfacePoint& first);
  void end();
  // The point under the pixel. A stroke that begins beside the organs continues on the first organ
  // that the pointer meets. If the pointer then leaves the organ, or jumps in depth (more than 20
  // mm and more than twice the way of the pointer), the stroke continues at the depth of its last
  // point, parallel to the plane of the picture. None if the last point is behind the camera.
  std::optional<SurfacePoint> along(const SbVec2s& pixel, const SbViewportRegion& viewport);

 private:
  Ray rayThrough(const SbVec2s& pixel, const SbViewportRegion& viewport) const;

  OperatingRoom& room_;
  std::vector<std::pair<SurfaceCopy, TriangleBlocks>> kept_;  // of the organs, at begin()
  SurfacePoint last_;                                         // last point of the stroke
  bool reached_ = false;                                      // the stroke has been on an organ
};

}  // namespace resect
