// Mouse and keys of the hand that holds tools.
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoHandleEventAction.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoEventCallback.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "inventor/gl/vectors.h"
#include "inventor/hand/tool_handling.h"
#include "inventor/hand/tool_keys.h"

namespace resect {
namespace {

constexpr int kClickPixels = 4;                           // a press that moves less is a click
constexpr double kWheelStep = 0.005;                      // m
constexpr double kKeyStep = 0.002;                        // m
constexpr double kTurnPerPixel = 0.006, kKeyTurn = 0.05;  // rad

}  // namespace

// At the depth of the held tool's tip.
double ToolHandling::metresPerPixel(const SoHandleEventAction& action) const {
  const SoPerspectiveCamera& camera = *room_.camera();
  const double depth =
      (pose(held_).position - toVec(camera.position.getValue())).dot(onScreen(Vec3::UnitZ()));
  const SbVec2s size = action.getViewportRegion().getViewportSizePixels();
  // Inventor's angle applies to the narrower side.
  return 2 * std::max(depth, 0.01) * std::tan(0.5 * camera.heightAngle.getValue()) /
         std::max<int>(1, std::min(size[0], size[1]));
}

// A way across the view, m, at the depth of the held tool's tip.
SbVec2s ToolHandling::pixelsOf(const Vec3& inView, const SoHandleEventAction& action) const {
  const double pixel = metresPerPixel(action);
  return {short(std::lround(inView.x() / pixel)), short(std::lround(inView.y() / pixel))};
}

void ToolHandling::heard(void* closure, SoEventCallback* node) {
  auto* self = static_cast<ToolHandling*>(closure);
  const SoEvent* event = node->getEvent();
  if (event->isOfType(SoMouseButtonEvent::getClassTypeId()))
    self->mouseButton(*node);
  else if (event->isOfType(SoLocation2Event::getClassTypeId()))
    self->mouseMoved(*node);
  else
    self->key(*node);
}

// The tool under the pointer, -1 for none; `dragger`: a part of the manipulator is in front.
int ToolHandling::toolUnder(SoEventCallback& node, bool& dragger) const {
  dragger = false;
  const SoPickedPoint* picked = node.getPickedPoint();
  if (!picked) return -1;
  const SoFullPath* path = static_cast<const SoFullPath*>(picked->getPath());
  for (int i = 0; i < path->getLength(); ++i)
    if (path->getNode(i)->isOfType(SoDragger::getClassTypeId())) dragger = true;
  return room_.toolOfPath(*path);
}

void ToolHandling::mouseButton(SoEventCallback& node) {
  const auto* event = static_cast<const SoMouseButtonEvent*>(node.getEvent());
  const bool down = event->getState() == SoButtonEvent::DOWN;
  const SbVec2s at = event->getPosition();
  const bool left = event->getButton() == SoMouseButtonEvent::BUTTON1;
  if (left && usual() == Hold::Guided && (how_ == Hold::Guided || how_ == Hold::None))
    return guidedButton(node, down);
  switch (event->getButton()) {
    case SoMouseButtonEvent::BUTTON1: {
      if (!down) {
        if (!dragging_ && elsewhere_) hold(-1, Hold::None);
        if (!dragging_ && !elsewhere_ && pressed_ >= 0) hold(pressed_, precise_);
        // The release of a press that the camera handled is the camera's too.
        if (pressed_ >= 0) node.setHandled();
        if (dragging_ && released) released();
        pressed_ = -1;
        elsewhere_ = dragging_ = false;
        return;
      }
      bool dragger = false;
      const int tool = toolUnder(node, dragger);
      pressedAt_ = lastAt_ = at;
      dragging_ = false;
      pressed_ = -1;
      elsewhere_ = false;
      if (dragger) return;  // handled by the manipulator
      elsewhere_ = tool < 0 && held_ >= 0;
      pressed_ = tool >= 0 ? tool : how_ == Hold::Direct ? held_ : -1;
      if (pressed_ >= 0) node.setHandled();
      return;
    }
    case SoMouseButtonEvent::BUTTON2:  // the middle one
      if (!down || held_ < 0) return;
      hold(held_, how_ == Hold::HandleBox ? Hold::Trackball : Hold::HandleBox);
      node.setHandled();
      return;
    case SoMouseButtonEvent::BUTTON4:
    case SoMouseButtonEvent::BUTTON5: {
      if (held_ < 0 || event->wasCtrlDown()) return;
      const double sign = event->getButton() == SoMouseButtonEvent::BUTTON4 ? 1 : -1;
      if (down) {
        if (how_ == Hold::Guided)
          guidedWheel(sign, event->wasShiftDown());
        else if (event->wasShiftDown())
          turn({0, 0, sign * kKeyTurn});
        else
          move({0, 0, sign * kWheelStep});
      }
      node.setHandled();
      return;
    }
    default:
      return;
  }
}

void ToolHandling::mouseMoved(SoEventCallback& node) {
  if (how_ == Hold::Guided) return guidedMove(node);
  pointer_ = node.getEvent()->getPosition();
  viewport_ = node.getAction()->getViewportRegion();
  // A key may have put back the dragged tool.
  if (dragging_ && held_ < 0) pressed_ = -1;
  if (pressed_ < 0) {
    if (elsewhere_) {
      const SbVec2s way = node.getEvent()->getPosition() - pressedAt_;
      // Moving the camera with a manipulator attached does not release the tool.
      if (std::max(std::abs(way[0]), std::abs(way[1])) > kClickPixels) elsewhere_ = false;
    }
    return;
  }
  const SbVec2s at = node.getEvent()->getPosition(), way = at - pressedAt_;
  if (!dragging_ && std::max(std::abs(way[0]), std::abs(way[1])) <= kClickPixels) {
    node.setHandled();
    return;
  }
  if (!dragging_) {
    dragging_ = true;
    hold(pressed_, Hold::Direct);
  }
  const double right = at[0] - lastAt_[0], up = at[1] - lastAt_[1];
  lastAt_ = at;
  if (node.getEvent()->wasShiftDown())
    turn(Vec3(-up, right, 0) * kTurnPerPixel);
  else
    move(Vec3(right, up, 0) * metresPerPixel(*node.getAction()));
  node.setHandled();
}

void ToolHandling::key(SoEventCallback& node) {
  const auto* event = static_cast<const SoKeyboardEvent*>(node.getEvent());
  const int key = event->getKey();
  const bool closes = key == SoKeyboardEvent::C, steps = key == SoKeyboardEvent::P && hasPedal();
  if ((closes || steps) && !event->wasCtrlDown() && held_ >= 0) {
    (closes ? squeezing_ : pedalling_) = event->getState() == SoButtonEvent::DOWN;
    notify();
    node.setHandled();
    return;
  }
  if (event->getState() != SoButtonEvent::DOWN) return;
  if (key == SoKeyboardEvent::F && !event->wasCtrlDown() && usual() == Hold::Guided) {
    // An instrument that only hovers has nothing to hold.
    if (held_ < 0 || (how_ == Hold::Guided && !pressing())) return;
    leave();
    node.setHandled();
    return;
  }
  if (const int tool = toolOfKey(key); tool >= 0) {
    if (tool >= toolCount() || event->wasCtrlDown()) return;
    take(tool);
    node.setHandled();
    return;
  }
  if (held_ < 0) return;
  struct Way {
    int key;
    double x, y, z;
  };
  static constexpr Way kWays[] = {
      {SoKeyboardEvent::LEFT_ARROW, -1, 0, 0}, {SoKeyboardEvent::RIGHT_ARROW, 1, 0, 0},
      {SoKeyboardEvent::UP_ARROW, 0, 1, 0},    {SoKeyboardEvent::DOWN_ARROW, 0, -1, 0},
      {SoKeyboardEvent::PAGE_UP, 0, 0, 1},     {SoKeyboardEvent::PAGE_DOWN, 0, 0, -1}};
  const auto* way = std::ranges::find(kWays, int(key), &Way::key);
  if (key == SoKeyboardEvent::ESCAPE)
    putBack(held_);
  else if (way == std::end(kWays))
    return;
  else if (how_ == Hold::Guided && way->z != 0)
    guidedWheel(way->z, event->wasShiftDown());
  else if (how_ == Hold::Guided && event->wasShiftDown())
    guidedWheel(way->x + way->y, true);
  else if (how_ == Hold::Guided)
    aim(pointer_ + pixelsOf(kKeyStep * Vec3(way->x, way->y, 0), *node.getAction()),
        node.getAction()->getViewportRegion());
  else if (event->wasShiftDown())
    turn(kKeyTurn * Vec3(-way->y, way->x, way->z));
  else
    move(kKeyStep * Vec3(way->x, way->y, way->z));
  node.setHandled();
}

}  // namespace resect
