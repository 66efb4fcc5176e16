#include "inventor/hand/pointed_surface.h"

#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>

#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/camera_moves.h"
#include "inventor/scene/operating_room.h"

namespace resect {
namespace {

constexpr double kReach = 5;    // m
constexpr double kJump = 0.02;  // m: a stroke may go so far up or down at once,
constexpr double kSlope = 2;    // or so many times its way

// With its normal on the side that the ray comes from. intoWounds: in a wound the normal is that of
// no face, but half upwards and half towards the eye, so that a blade goes on into the depth of the
// wound and not into its walls.
SurfacePoint seenFrom(const Ray& ray, const OrganPoint& at, bool intoWounds) {
  constexpr double kWall = 0.5;  // cut share
  SurfacePoint seen = at;
  if (intoWounds && at.cut > kWall) seen.normal = Vec3::UnitY() - ray.direction;
  if (seen.normal.dot(ray.direction) > 0) seen.normal = -seen.normal;
  seen.normal.normalize();
  return seen;
}

}  // namespace

// The direction is a unit vector.
Ray PointedSurface::rayThrough(const SbVec2s& pixel, const SbViewportRegion& viewport) const {
  const SbViewVolume volume = viewVolumeOf(*room_.camera(), viewport);
  const SbVec2s size = viewport.getViewportSizePixels();
  SbVec3f from, towards;
  volume.projectPointToLine(SbVec2f(float(pixel[0]) / size[0], float(pixel[1]) / size[1]), from,
                            towards);
  const Vec3 origin(from[0], from[1], from[2]);
  return {origin, (Vec3(towards[0], towards[1], towards[2]) - origin).normalized()};
}

std::optional<SurfacePoint> PointedSurface::under(const SbVec2s& pixel,
                                                  const SbViewportRegion& viewport,
                                                  bool intoWounds) const {
  // The organs are excluded from Inventor's picking for speed.
  const Ray ray = rayThrough(pixel, viewport);
  std::optional<SurfacePoint> nearest;
  const auto take = [&](const SurfacePoint& at) {
    const double far = (at.point - ray.origin).norm();
    if (far < (nearest ? (nearest->point - ray.origin).norm() : kReach)) nearest = at;
  };
  for (int o = 0; o < room_.organCount(); ++o)
    if (const auto on = room_.organ(o)->firstPointOn(ray)) take(seenFrom(ray, *on, intoWounds));
  const double table = -ray.origin.y() / ray.direction.y();  // its plane, y = 0
  if (table >= 0) take({ray.at(table), Vec3::UnitY()});
  return nearest;
}

void PointedSurface::begin(const SurfacePoint& first) {
  end();
  last_ = first;
  reached_ = landed_ = false;
  for (int o = 0; o < room_.organCount(); ++o) kept_.push_back(room_.organ(o)->snapshot());
}

void PointedSurface::end() { kept_.clear(); }

std::optional<SurfacePoint> PointedSurface::along(const SbVec2s& pixel,
                                                  const SbViewportRegion& viewport,
                                                  bool intoWounds) {
  const Ray ray = rayThrough(pixel, viewport);
  const Vec3 axis = rayThrough(SbVec2s(viewport.getViewportSizePixels() / short(2)), viewport)
                        .direction;  // of the view
  const double slant = ray.direction.dot(axis);
  const double depth = (last_.point - ray.origin).dot(axis) / slant;
  if (!(depth > 0)) return std::nullopt;
  const Vec3 beside = ray.at(depth);
  const bool was = reached_;
  SurfacePoint next{beside, last_.normal};
  double nearest = reached_ ? std::max(kJump, kSlope * (beside - last_.point).norm())
                            : (beside - ray.origin).norm();
  for (const auto& [surface, blocks] : kept_) {
    const auto on = firstPointOn(surface, blocks, ray);
    if (!on || (on->point - beside).norm() > nearest) continue;
    nearest = (on->point - beside).norm();
    next = seenFrom(ray, *on, intoWounds);
    reached_ = true;
  }
  landed_ = reached_ && !was && (next.point - last_.point).norm() > kJump;
  return last_ = next;
}

}  // namespace resect
