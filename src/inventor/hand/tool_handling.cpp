#include "inventor/hand/tool_handling.h"
#include "inventor/gl/vectors.h"

#include <Inventor/SoPath.h>
#include <Inventor/actions/SoGetMatrixAction.h>
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

#include <utility>

#include "base/error.h"
#include "operation/room.h"

namespace resect {
namespace {

constexpr float kScaleRounding = 1e-8f;  // squared distance of scales

SoPath* pathTo(SoNode* root, SoNode* node) {
  SoSearchAction search;
  search.setSearchingAll(TRUE);  // a tool at rest may be hidden
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
      bodies_(rests_.size(), nullptr),
      left_(rests_.size()),
      pointed_(room) {
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
  endPress();
  pressed_ = -1;
  elsewhere_ = dragging_ = false;
}

void ToolHandling::hold(int tool, Hold how) {
  if (tool != -1) requireTool(tool);
  if (tool < 0) how = Hold::None;
  if (how == Hold::None) tool = -1;
  if (tool == held_ && how == how_) return;
  detach();
  endPress();
  held_ = tool;
  how_ = how;
  squeezing_ = pedalling_ = false;
  if (tool >= 0) left_[std::size_t(tool)] = 0;
  if (how == Hold::HandleBox || how == Hold::Trackball) attach(tool, how);
  if (how == Hold::Guided) takeUpHeld();
  if (how == Hold::Direct && atRest(tool)) {
    // Its tip moves to its former middle, where the pointer is.
    setPose(tool, {room_.toolBounds(tool).centre(), workingRotation()});
  }
  notify();
}

void ToolHandling::take(int tool) {
  requireTool(tool);
  if (tool != held_ && usual() == Hold::Guided && held_ >= 0) pressing() ? leave() : putBack(held_);
  const bool rested = atRest(tool);
  hold(tool, usual());
  if (rested && !surfaceHand()) setPose(tool, {readyPlace, workingRotation()});
}

void ToolHandling::leave() {
  if (held_ < 0) return;
  detach();
  const int tool = std::exchange(held_, -1);
  how_ = Hold::None;
  left_[std::size_t(tool)] = 1;
  endPress();
  if (released) released();
  notify();
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
    endPress();
    held_ = -1;
    how_ = Hold::None;
  }
  left_[std::size_t(tool)] = 0;
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

}  // namespace resect
