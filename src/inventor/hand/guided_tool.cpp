// The hand that guides a tool over the organ's surface.
#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoHandleEventAction.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoEventCallback.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include "base/error.h"
#include "inventor/gl/camera_moves.h"
#include "inventor/gl/vectors.h"
#include "inventor/hand/tool_handling.h"

namespace resect {
namespace {

constexpr double kDepthStep = 0.002;                          // m, of a notch of the wheel
constexpr double kTurnPerNotch = 0.1, kTurnPerPixel = 0.006;  // rad

bool isIn(const SbVec2s& pixel, const SbViewportRegion& viewport) {
  const SbVec2s size = viewport.getViewportSizePixels();
  return pixel[0] >= 0 && pixel[1] >= 0 && pixel[0] < size[0] && pixel[1] < size[1];
}

}  // namespace

void ToolHandling::guide(std::span<const ToolModel> models, double spacing) {
  require(int(models.size()) == toolCount(), "there are {} models for {} tools; give one for each",
          models.size(), toolCount());
  models_ = models;
  styles_.clear(), depths_.clear();
  for (const ToolModel& model : models_) {
    styles_.push_back(handStyleOf(model, spacing));
    depths_.push_back(styles_.back().depth);
  }
}

bool ToolHandling::hasPedal() const {
  return held_ >= 0 && !models_.empty() && models_[std::size_t(held_)].kind == "pencil";
}

bool ToolHandling::squeezing() const {
  return squeezing_ || (pressing() && hand_.style.closesJaws);
}

const SurfaceHand* ToolHandling::surfaceHand() const {
  return how_ == Hold::Guided && hand_.pointing ? &hand_ : nullptr;
}

Pose ToolHandling::wanted(int tool) const {
  if (tool != held_ || !surfaceHand()) return pose(tool);
  SurfaceHand hand = hand_;
  if (pedalling_) hand.depth = 0;  // sparks go from the tip to the surface
  return poseAboveTable(hand, models_[std::size_t(tool)].mesh.points);
}

// The tool that is now held is brought to the pointer, its handle towards the viewer.
void ToolHandling::takeUpHeld() {
  const HandStyle& style = styles_[std::size_t(held_)];
  Vec3 towardsViewer = -onScreen(Vec3::UnitZ());
  towardsViewer.y() = 0;
  hand_ = takeUp(style, style.forward < 0 ? Vec3(-towardsViewer) : towardsViewer);
  hand_.depth = depths_[std::size_t(held_)];
  if (!viewport_ || !isIn(pointer_, *viewport_)) return;
  if (const auto at = pointed_.under(pointer_, *viewport_, style.entersSlowly)) pointAt(hand_, *at);
  seekUnder(pointer_, *viewport_);
}

void ToolHandling::aim(const SbVec2s& pixel, const SbViewportRegion& viewport) {
  pointer_ = pixel;
  viewport_ = viewport;
  const bool blade = hand_.style.entersSlowly;
  const auto at =
      pressing() ? pointed_.along(pixel, viewport, blade) : pointed_.under(pixel, viewport, blade);
  if (!at) return;
  if (pressing() && pointed_.landed())
    landAt(hand_, *at);
  else
    pointAt(hand_, *at);
  if (pressing() && !pointed_.reached()) hand_.stroke = 0;  // it is drawn beside the organs
  seekUnder(pixel, viewport);
  notify();
}

// The hand may go to the target that is seen nearest to the pointer.
void ToolHandling::seekUnder(const SbVec2s& pixel, const SbViewportRegion& viewport) {
  const SbViewVolume volume = viewVolumeOf(*room_.camera(), viewport);
  const SbVec2s size = viewport.getViewportSizePixels();
  const Vec3* nearest = nullptr;
  float least = 0;
  for (const Vec3& target : targets_) {
    SbVec3f screen;
    volume.projectToScreen(SbVec3f(float(target.x()), float(target.y()), float(target.z())),
                           screen);
    const float x = screen[0] * float(size[0]) - float(pixel[0]),
                y = screen[1] * float(size[1]) - float(pixel[1]), off = x * x + y * y;
    if (!nearest || off < least) least = off, nearest = &target;
  }
  if (!hand_.pointing) return;
  const Vec3 eye = toVec(room_.camera()->position.getValue());
  seek(hand_, nearest ? std::span(nearest, 1) : std::span<const Vec3>(),
       (eye - hand_.at.point).normalized());
}

void ToolHandling::setTargets(std::vector<Vec3> targets) {
  constexpr double kSeen = 0.5e-3;  // m
  targets_ = std::move(targets);
  if (!surfaceHand() || hand_.pressing) return;
  const auto before = hand_.target;
  if (viewport_) seekUnder(pointer_, *viewport_);
  const bool same =
      before ? hand_.target && (*before - *hand_.target).norm() < kSeen : !hand_.target;
  if (same)
    hand_.target = before;
  else
    notify();
}

void ToolHandling::aimAgain() {
  if (how_ == Hold::Guided && !hand_.pressing && viewport_ && isIn(pointer_, *viewport_))
    aim(pointer_, *viewport_);
}

void ToolHandling::startPress() {
  pressedFrom_ = wanted(held_);
  press(hand_);
  pointed_.begin(hand_.at);
  notify();
}

void ToolHandling::endPress() {
  if (!hand_.pressing) return;
  lift(hand_);
  pointed_.end();
}

// A press on a tool takes it, elsewhere the tool in hand works until the release.
void ToolHandling::guidedButton(SoEventCallback& node, bool down) {
  const SbVec2s at = node.getEvent()->getPosition();
  const SbViewportRegion& viewport = node.getAction()->getViewportRegion();
  if (!down) {
    if (!pressing()) return;
    endPress();
    aim(at, viewport);
    if (released) released();
    notify();
    node.setHandled();
    return;
  }
  bool dragger = false;
  const int tool = toolUnder(node, dragger);
  if (dragger) return;
  pointer_ = at;
  viewport_ = viewport;
  // Over a ring the instrument in hand works, even if a swab lies there.
  if (tool >= 0 && tool != held_ && !(held_ >= 0 && surfaceHand() && hand_.target)) {
    take(tool);
  } else if (held_ >= 0) {
    aim(at, viewport);
    if (surfaceHand()) startPress();
  } else {
    return;
  }
  node.setHandled();
}

void ToolHandling::guidedMove(SoEventCallback& node) {
  const SbVec2s at = node.getEvent()->getPosition();
  if (node.getEvent()->wasShiftDown()) {
    turnHeading(hand_, kTurnPerPixel * (at[0] - pointer_[0]));
    pointer_ = at;
    notify();
  } else {
    aim(at, node.getAction()->getViewportRegion());
  }
  node.setHandled();
}

void ToolHandling::guidedWheel(double notches, bool turning) {
  if (turning)
    turnHeading(hand_, kTurnPerNotch * notches);
  else
    goDeeper(hand_, kDepthStep * notches);
  depths_[std::size_t(held_)] = hand_.depth;
  notify();
}

}  // namespace resect
