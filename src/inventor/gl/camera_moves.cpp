#include "inventor/gl/camera_moves.h"
#include "inventor/gl/vectors.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr double kOrbitPerPixel = 0.006;  // rad
constexpr double kZoomPerStep = 0.88;

Vec3 axisOf(const SoPerspectiveCamera& camera, const SbVec3f& axis) {
  SbVec3f world;
  camera.orientation.getValue().multVec(axis, world);
  return toVec(world);
}

void place(SoPerspectiveCamera& camera, const Vec3& position, const Vec3& target) {
  camera.position = toSb(position);
  camera.pointAt(toSb(target), SbVec3f(0, 1, 0));
  const double distance = (target - position).norm();
  camera.focalDistance = float(distance);
  camera.nearDistance = float(std::min(0.05, 0.05 * distance));
  camera.farDistance = float(20.0 * std::max(distance, 0.5));
}

}  // namespace

SbViewVolume viewVolumeOf(const SoPerspectiveCamera& camera, const SbViewportRegion& viewport) {
  const float aspect = viewport.getViewportAspectRatio();
  SbViewVolume volume = camera.getViewVolume(aspect);
  // As Coin's ADJUST_CAMERA: the angle applies to the narrower side.
  if (aspect < 1) volume.scale(1 / aspect);
  return volume;
}

Vec3 CameraMoves::pointOfInterest() const {
  return toVec(camera_->position.getValue()) +
         double(camera_->focalDistance.getValue()) * axisOf(*camera_, SbVec3f(0, 0, -1));
}

void CameraMoves::orbit(double right, double up) {
  constexpr double kSteepest = 1.55;  // rad: less than straight down, where "up" is undefined
  const Vec3 target = pointOfInterest();
  const Vec3 away = toVec(camera_->position.getValue()) - target;
  const double distance = away.norm();
  const double turn = std::atan2(away.x(), away.z()) - right;
  const double height =
      std::clamp(std::asin(std::clamp(away.y() / distance, -1.0, 1.0)) - up, lowest, kSteepest);
  const Vec3 direction(std::cos(height) * std::sin(turn), std::sin(height),
                       std::cos(height) * std::cos(turn));
  place(*camera_, target + distance * direction, target);
}

void CameraMoves::pan(double right, double up) {
  const Vec3 way =
      right * axisOf(*camera_, SbVec3f(1, 0, 0)) + up * axisOf(*camera_, SbVec3f(0, 1, 0));
  const Vec3 target = pointOfInterest();
  place(*camera_, toVec(camera_->position.getValue()) - way, target - way);
}

void CameraMoves::zoom(double factor) {
  const Vec3 target = pointOfInterest();
  const Vec3 away = toVec(camera_->position.getValue()) - target;
  const double distance = std::clamp(away.norm() * factor, 0.05, 10.0);
  place(*camera_, target + distance * away.normalized(), target);
}

void CameraMoves::zoomAt(const Vec3& point, double factor) {
  const Vec3 position = toVec(camera_->position.getValue()), target = pointOfInterest();
  const double distance = (target - position).norm();
  const double share = std::clamp(distance * factor, 0.05, 10.0) / distance;
  place(*camera_, point + share * (position - point), point + share * (target - point));
}

void CameraMoves::zoomToPointer(const SbVec2s& at, const SbViewportRegion& viewport,
                                double factor) {
  constexpr double kFar = 2;  // distances to the point of interest: the room behind the field
  const Vec3 position = toVec(camera_->position.getValue());
  const double distance = camera_->focalDistance.getValue();
  const std::optional<Vec3> seen = pointUnder ? pointUnder(at, viewport) : std::nullopt;
  if (seen && (*seen - position).norm() < kFar * distance) return zoomAt(*seen, factor);
  const SbVec2s size = viewport.getViewportSizePixels();
  const double metres = metresPerPixel(viewport);
  zoomAt(pointOfInterest() + (at[0] - 0.5 * size[0]) * metres * axisOf(*camera_, {1, 0, 0}) +
             (at[1] - 0.5 * size[1]) * metres * axisOf(*camera_, {0, 1, 0}),
         factor);
}

void CameraMoves::lookAt(const Vec3& point) {
  place(*camera_, toVec(camera_->position.getValue()), point);
}

// At the point of interest.
double CameraMoves::metresPerPixel(const SbViewportRegion& viewport) const {
  const SbVec2s size = viewport.getViewportSizePixels();
  return 2.0 * camera_->focalDistance.getValue() * std::tan(0.5 * camera_->heightAngle.getValue()) /
         std::max<int>(1, std::min(size[0], size[1]));
}

bool CameraMoves::handle(const SoEvent& event, const SbViewportRegion& viewport) {
  if (event.isOfType(SoMouseButtonEvent::getClassTypeId())) {
    const auto& mouse = static_cast<const SoMouseButtonEvent&>(event);
    const int button = mouse.getButton();
    const bool down = mouse.getState() == SoButtonEvent::DOWN;
    if (button == SoMouseButtonEvent::BUTTON4 || button == SoMouseButtonEvent::BUTTON5) {
      if (down)
        zoomToPointer(event.getPosition(), viewport,
                      button == SoMouseButtonEvent::BUTTON4 ? kZoomPerStep : 1 / kZoomPerStep);
      return true;
    }
    if (!down) {
      if (button == button_) drag_ = Drag::None;
      return true;
    }
    button_ = button;
    lastAt_ = mouse.getPosition();
    drag_ = button == SoMouseButtonEvent::BUTTON2 || mouse.wasShiftDown() ? Drag::Pan : Drag::Orbit;
    return true;
  }
  if (event.isOfType(SoLocation2Event::getClassTypeId()) && drag_ != Drag::None) {
    const SbVec2s at = event.getPosition(), way = at - lastAt_;
    lastAt_ = at;
    const double metres = metresPerPixel(viewport);
    if (drag_ == Drag::Orbit)
      orbit(way[0] * kOrbitPerPixel, way[1] * kOrbitPerPixel);
    else
      pan(way[0] * metres, way[1] * metres);
    return true;
  }
  return false;
}

}  // namespace resect
