// The named views of the operating room, and its lamps.
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSpotLight.h>
#include <Inventor/nodes/SoSwitch.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "inventor/gl/SoShadowMaps.h"
#include "inventor/gl/vectors.h"
#include "inventor/scene/operating_room.h"

namespace resect {
namespace {

// Main lamp and second lamp for each LampPlace, from the middle of what they light; m.
const Vec3 kLampPlaces[][2] = {{{-0.50, 1.20, -0.10}, {0.85, 0.95, 0.45}},
                               {{0.85, 0.95, 0.00}, {-0.85, 0.95, 0.45}},
                               {{-0.20, 1.05, 0.75}, {0.85, 0.95, -0.45}},
                               {{0.02, 1.30, 0.02}, {0.85, 0.95, 0.45}}};

struct Direction {
  Vec3 towards;        // from the target to the camera
  double heightAngle;  // rad
  double margin;       // factor by which the picture is larger than the sphere round the box
  Vec3 aside;  // offset of the target from the middle of the box, in radii, per (aspect - 1)
};

Direction direction(RoomView view) {
  switch (view) {
    case RoomView::Surgeon:
      return {{0.06, 0.62, 1.0}, 0.50, 1.08, {0.66, -0.06, 0.0}};
    case RoomView::Assistant:
      return {{-1.0, 0.55, -0.55}, 0.48, 1.0, {0.0, 0.0, 0.0}};
    case RoomView::Top:
      return {{0.0, 1.0, 1e-3}, 0.48, 1.0, {0.0, 0.0, 0.0}};
    case RoomView::Laparoscope:
      return {{0.35, 0.48, 0.85}, 1.15, 0.80, {0.0, 0.0, 0.0}};
  }
  throw usageError("there is no view {} of the room; use one of RoomView", int(view));
}

void requireAspect(double aspect) {
  require(aspect > 0 && std::isfinite(aspect),
          "the picture's width is {} times its height; give a number above 0", aspect);
}

struct ViewAxes {
  Vec3 right, up, back;  // unit
};

// Distance from the middle of the box to a camera that sees all of it. Inventor's angle applies to
// the narrower side.
double distanceToFit(const Aabb& box, const ViewAxes& axes, double heightAngle, double aspect) {
  const double narrow = 0.93 * std::tan(0.5 * heightAngle);
  const double tanX = narrow * std::max(1.0, aspect), tanY = narrow * std::max(1.0, 1 / aspect);
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = box.corner(corner) - box.centre();
    const double nearer = p.dot(axes.back);
    distance = std::max({distance, nearer + std::abs(p.dot(axes.right)) / tanX,
                         nearer + std::abs(p.dot(axes.up)) / tanY});
  }
  return distance;
}

}  // namespace

Vec3 towardsCamera(RoomView view) { return direction(view).towards.normalized(); }

std::optional<RoomView> roomView(std::string_view name) {
  if (name == "surgeon") return RoomView::Surgeon;
  if (name == "assistant") return RoomView::Assistant;
  if (name == "top") return RoomView::Top;
  if (name == "laparoscope") return RoomView::Laparoscope;
  return std::nullopt;
}

void OperatingRoom::look(RoomView view, const Aabb& box, double aspect) {
  requireAspect(aspect);
  if (box.empty()) return;
  const Direction from = direction(view);
  const double radius = std::max(0.5 * box.size().norm(), 1e-3);
  // Only wide pictures have room for the tool box beside the organ, and only of an organ so large
  // that the tool box, which stands where it stands, is in sight.
  constexpr double kLarge = 0.08;  // m
  const bool beside = toolboxModel() && radius > kLarge;
  const double aside = beside ? std::clamp(aspect - 1.0, 0.0, 0.8) : 0.0;
  // Fits the sphere round the box; Inventor's angle applies to the narrower side.
  place(view, box.centre() + aside * radius * from.aside,
        from.margin * radius / std::sin(0.5 * from.heightAngle));
}

void OperatingRoom::frame(RoomView view, const Aabb& box, double aspect) {
  requireAspect(aspect);
  if (box.empty()) return;
  const Direction from = direction(view);
  const Vec3 back = from.towards.normalized(), right = Vec3::UnitY().cross(back).normalized();
  place(view, box.centre(),
        distanceToFit(box, {right, back.cross(right), back}, from.heightAngle, aspect));
}

void OperatingRoom::closeUp(RoomView view, const Vec3& centre, double silhouette, double share,
                            double aspect) {
  requireAspect(aspect);
  require(silhouette > 0 && share > 0,
          "a silhouette of {} m^2 cannot fill {} of a picture; give two numbers above 0",
          silhouette, share);
  const double narrow = std::tan(0.5 * direction(view).heightAngle);
  const double wide = narrow * std::max(aspect, 1 / aspect);
  place(view, centre, std::sqrt(silhouette / (4 * share * narrow * wide)));
}

void OperatingRoom::viewAll(const Aabb& box, double aspect) {
  requireAspect(aspect);
  if (box.empty()) return;
  Vec3 axes[3];
  for (int a = 0; a < 3; ++a) {
    SbVec3f axis;
    camera_->orientation.getValue().multVec(SbVec3f(a == 0, a == 1, a == 2), axis);
    axes[a] = Vec3(axis[0], axis[1], axis[2]);
  }
  const double distance = distanceToFit(box, {axes[0], axes[1], axes[2]},
                                        double(camera_->heightAngle.getValue()), aspect);
  camera_->position = toSb(box.centre() + distance * axes[2]);
  camera_->focalDistance = float(distance);
  camera_->nearDistance = float(0.05 * distance);
  camera_->farDistance = float(20.0 * distance);
}

bool OperatingRoom::throughScope() const { return scope_->whichChild.getValue() == SO_SWITCH_ALL; }

void OperatingRoom::lightUp(const Aabb& box) {
  if (box.empty()) return;
  const Vec3 centre = box.centre();
  const double radius = std::max(0.5 * box.size().norm(), 1e-3);
  lit_ = box;
  const auto& places = kLampPlaces[std::size_t(lampPlace_)];
  // Lamps hang 1.3 m from a liver; for larger models the distance is scaled.
  const double scale = std::max(1.0, radius / 0.2);
  for (int k = 0; k < 2; ++k) {
    lamps_[k]->location = toSb(centre + scale * places[k]);
    lamps_[k]->direction = toSb(-places[k].normalized());
    lamps_[k]->cutOffAngle = k == 0 ? 0.42f : 0.60f;
  }
  shadows_->lampPosition = lamps_[0]->location.getValue();
  shadows_->focus = toSb(centre);
  shadows_->radius = float(std::max(0.46, 1.5 * radius));
}

void OperatingRoom::moveLamp(LampPlace place) {
  lampPlace_ = place;
  lightUp(lit_);
}

// A laparoscope looks into a dark belly by its own light.
void OperatingRoom::setLights(RoomView view) {
  const bool scope = view == RoomView::Laparoscope;
  scope_->whichChild = fieldDome_->whichChild = scope ? SO_SWITCH_ALL : SO_SWITCH_NONE;
  fieldWall_->whichChild = scope ? SO_SWITCH_NONE : SO_SWITCH_ALL;
  lamps_[0]->intensity = scope ? 0.03f : 1.0f;
  lamps_[1]->intensity = scope ? 0.015f : 0.28f;
  head_->intensity = scope ? 0.18f : 0.25f;
  head_->cutOffAngle = scope ? 0.52f : 0.389f;
  head_->dropOffRate = scope ? 1.0f : 0.0f;
  updateHands();
}

void OperatingRoom::place(RoomView view, const Vec3& target, double distance) {
  setLights(view);
  const Direction from = direction(view);
  camera_->heightAngle = float(from.heightAngle);
  camera_->position = toSb(target + distance * from.towards.normalized());
  camera_->pointAt(toSb(target), SbVec3f(0.0f, 1.0f, 0.0f));
  camera_->focalDistance = float(distance);
  camera_->nearDistance = float(0.05 * distance);
  camera_->farDistance = float(20.0 * distance);
}

}  // namespace resect
