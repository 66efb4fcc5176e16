#include "inventor/hand/tool_handling.h"

#include <Inventor/SoPath.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoGetMatrixAction.h>
#include <Inventor/actions/SoHandleEventAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/manips/SoHandleBoxManip.h>
#include <Inventor/manips/SoTrackballManip.h>
#include <Inventor/nodes/SoEventCallback.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "operation/room.h"

namespace resect {
namespace {

constexpr float kScaleRounding = 1e-8f;                   // squared distance of scales
constexpr int kClickPixels = 4;                           // a press that moves less is a click
constexpr double kWheelStep = 0.005;                      // m
constexpr double kKeyStep = 0.002;                        // m
constexpr double kTurnPerPixel = 0.006, kKeyTurn = 0.05;  // rad

Vec3 toVec(const SbVec3f& v) { return {v[0], v[1], v[2]}; }

SoPath* pathTo(SoNode* root, SoNode* node) {
  SoSearchAction search;
  search.setNode(node);
  search.apply(root);
  require(search.getPath() != nullptr, "the tool is not in the room; add it there first");
  SoPath* path = search.getPath()->copy();
  path->ref();
  return path;
}

}  // namespace

ToolHandling::ToolHandling(OperatingRoom& room, std::vector<Pose> rests)
    : room_(room),
      events_(new SoEventCallback),
      rests_(std::move(rests)),
      bodies_(rests_.size(), nullptr) {
  for (const SoType type : {SoMouseButtonEvent::getClassTypeId(),
                            SoLocation2Event::getClassTypeId(), SoKeyboardEvent::getClassTypeId()})
    events_->addEventCallback(type, heard, this);
  room_.addListener(events_);
}

ToolHandling::~ToolHandling() {
  detach();
  for (SoPath* body : bodies_)
    if (body) body->unref();
  room_.removeListener(events_);
}

// As in the thesis: from the matrix of the path to the tool's body, without the scale that a handle
// box may have written.
Pose ToolHandling::pose(int tool) const {
  requireTool(tool);
  SoPath*& body = bodies_[std::size_t(tool)];
  if (!body) body = pathTo(room_.root(), room_.toolModel(tool));
  SoGetMatrixAction matrix(SbViewportRegion(1, 1));
  matrix.apply(body);
  SbVec3f at, scale;
  SbRotation turn, scaleTurn;
  matrix.getMatrix().getTransform(at, turn, scale, scaleTurn);
  const float* q = turn.getValue();
  return {toVec(at), Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized()};
}

void ToolHandling::requireTool(int tool) const {
  require(tool >= 0 && tool < toolCount(), "there is no tool {} among {}; number from 0", tool,
          toolCount());
}

void ToolHandling::setPose(int tool, const Pose& pose) {
  room_.setToolPose(tool, constrain ? constrain(tool, pose) : pose);
  notify();
}

void ToolHandling::interrupt() {
  pressed_ = -1;
  elsewhere_ = dragging_ = false;
}

void ToolHandling::hold(int tool, Hold how) {
  if (tool != -1) requireTool(tool);
  if (tool < 0) how = Hold::None;
  if (how == Hold::None) tool = -1;
  if (tool == held_ && how == how_) return;
  detach();
  held_ = tool;
  how_ = how;
  squeezing_ = false;
  if (how == Hold::HandleBox || how == Hold::Trackball) attach(tool, how);
  if (how == Hold::Direct && atRest(tool)) {
    // Its tip moves to its former middle, where the pointer is.
    setPose(tool, {room_.toolBounds(tool).centre(), workingRotation()});
  }
  notify();
}

void ToolHandling::take(int tool) {
  const bool rested = atRest(tool);
  hold(tool, Hold::Direct);
  if (rested) setPose(tool, {readyPlace, workingRotation()});
}

bool ToolHandling::atRest(int tool) const {
  const Pose &now = pose(tool), &rest = rests_[std::size_t(tool)];
  return (now.position - rest.position).norm() < 1e-4 &&
         now.rotation.angularDistance(rest.rotation) < 1e-2;
}

void ToolHandling::putBack(int tool) {
  if (tool < 0) return;
  requireTool(tool);
  if (tool == held_) {
    detach();
    held_ = -1;
    how_ = Hold::None;
  }
  room_.setToolPose(tool, rests_[std::size_t(tool)]);
  notify();
}

// Replaces the tool's SoTransform by a manipulator.
void ToolHandling::attach(int tool, Hold how) {
  precise_ = how;
  auto* manipulator = how == Hold::HandleBox ? static_cast<SoTransformManip*>(new SoHandleBoxManip)
                                             : new SoTrackballManip;
  manipulator->ref();
  SoPath* path = pathTo(room_.root(), room_.toolTransform(tool));
  manipulator->replaceNode(path);
  path->unref();
  manipulator->unrefNoDelete();
  place_ = manipulator->translation.getValue();
  manipulator->getDragger()->addValueChangedCallback(draggerMoved, this);
}

// Restores the SoTransform with the manipulator's position and rotation.
void ToolHandling::detach() {
  if (how_ != Hold::HandleBox && how_ != Hold::Trackball) return;
  SoTransform* node = room_.toolTransform(held_);
  auto* manipulator = static_cast<SoTransformManip*>(node);
  manipulator->getDragger()->removeValueChangedCallback(draggerMoved, this);
  SoPath* path = pathTo(room_.root(), manipulator);
  auto* plain = new SoTransform;
  manipulator->replaceManip(path, plain);
  path->unref();
  plain->scaleFactor.setValue(1, 1, 1);
}

void ToolHandling::draggerMoved(void* closure, SoDragger*) {
  auto* self = static_cast<ToolHandling*>(closure);
  SoTransform* transform = self->room_.toolTransform(self->held_);
  // Instruments keep their size, and do not move as scaling about the box's centre would move them.
  // A scale within rounding is ignored: resetting it would make the dragger write it again,
  // endlessly.
  if (transform->scaleFactor.getValue().equals(SbVec3f(1, 1, 1), kScaleRounding)) {
    self->place_ = transform->translation.getValue();
  } else {
    // Notified together with the scale: in between the instrument would be seen to jump.
    transform->translation.enableNotify(FALSE);
    transform->translation = self->place_;
    transform->translation.enableNotify(TRUE);
    transform->scaleFactor = {1, 1, 1};
  }
  self->notify();
}

Vec3 ToolHandling::onScreen(const Vec3& inView) const {
  SbVec3f world;
  room_.camera()->orientation.getValue().multVec(
      SbVec3f(float(inView.x()), float(inView.y()), float(-inView.z())), world);
  return toVec(world);
}

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

void ToolHandling::move(const Vec3& inView) {
  if (held_ < 0) return;
  Pose moved = pose(held_);
  moved.position += onScreen(inView);
  setPose(held_, moved);
}

void ToolHandling::turn(const Vec3& inView) {
  const double angle = inView.norm();
  if (held_ < 0 || angle == 0) return;
  Pose turned = pose(held_);
  const Vec3 axis = onScreen(Vec3(inView.x(), inView.y(), inView.z()) / angle);
  turned.rotation =
      (Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * turned.rotation).normalized();
  setPose(held_, turned);
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
        if (event->wasShiftDown())
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
  if (key == SoKeyboardEvent::C && !event->wasCtrlDown() && held_ >= 0) {
    squeezing_ = event->getState() == SoButtonEvent::DOWN;
    notify();
    node.setHandled();
    return;
  }
  if (event->getState() != SoButtonEvent::DOWN) return;
  if (key >= SoKeyboardEvent::NUMBER_1 && key <= SoKeyboardEvent::NUMBER_9) {
    const int tool = key - SoKeyboardEvent::NUMBER_1;
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
  else if (event->wasShiftDown())
    turn(kKeyTurn * Vec3(-way->y, way->x, way->z));
  else
    move(kKeyStep * Vec3(way->x, way->y, way->z));
  node.setHandled();
}

}  // namespace resect
