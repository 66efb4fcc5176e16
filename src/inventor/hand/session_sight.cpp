// What an operating session shows where: points of organs and instruments in the picture, and by
// which light.
#include <Inventor/SbViewportRegion.h>

#include <cmath>

#include "inventor/gl/vectors.h"
#include "inventor/hand/operating_session.h"
#include "inventor/hand/pointed_surface.h"

namespace resect {

void OperatingSession::noteSight(const SbViewportRegion& viewport) {
  constexpr double kScopeRadius = 0.97;  // of half the picture's height (scope.frag)
  const SbViewVolume volume = viewVolumeOf(*room().camera(), viewport);
  const double aspect = viewport.getViewportAspectRatio();
  std::vector<Sight> sight(toolModels_.size(), Sight::Unknown);
  for (std::size_t t = 0; t < sight.size() && t < state_.poses.size(); ++t) {
    const Vec3 tip = state_.poses[t] * toolModels_[t].tip;
    SbVec3f screen;  // 0 to 1, in depth too
    volume.projectToScreen(toSb(tip), screen);
    const double x = 2 * screen[0] - 1, y = 2 * screen[1] - 1;
    const bool ahead = screen[2] > 0 && screen[2] < 1;
    const bool seen = room().throughScope() ? std::hypot(aspect * x, y) < kScopeRadius
                                            : std::abs(x) < 1 && std::abs(y) < 1;
    sight[t] = ahead && seen ? Sight::Seen : Sight::Unseen;
  }
  operation_.setSight(std::move(sight));
}

void OperatingSession::moveLamp(LampPlace place) {
  room().moveLamp(place);
  damage_.everything = true;
}

std::optional<SurfacePoint> OperatingSession::pointUnder(const SbVec2s& pixel,
                                                         const SbViewportRegion& viewport) const {
  return PointedSurface(room()).under(pixel, viewport);
}

SbVec2s OperatingSession::pixelOf(const Vec3& point, const SbViewportRegion& viewport) const {
  const SbViewVolume volume = viewVolumeOf(*room().camera(), viewport);
  SbVec3f screen;
  volume.projectToScreen(SbVec3f(float(point.x()), float(point.y()), float(point.z())), screen);
  const SbVec2s size = viewport.getViewportSizePixels();
  return {short(screen[0] * size[0]), short(screen[1] * size[1])};
}

Vec3 OperatingSession::middleOfTool(int tool) const {
  return tools_.pose(tool) * bounds(toolModels_[std::size_t(tool)].mesh).centre();
}

}  // namespace resect
