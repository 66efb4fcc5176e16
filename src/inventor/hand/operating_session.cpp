#include "inventor/hand/operating_session.h"

#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSpotLight.h>
#include <Inventor/sensors/SoSensorManager.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/moved_box.h"
#include "inventor/gl/SoOrganShape.h"
#include "operation/room.h"

namespace resect {
namespace {

constexpr double kSlow = 0.0015;  // m/s: tissue that moves slower may be drawn a little later

std::vector<ToolModel> modelsOf(const Simulation& simulation) {
  std::vector<ToolModel> models;
  for (const ToolState& state : simulation.tools()) models.push_back(state.tool->model);
  return models;
}

std::vector<Pose> restsOf(const Scenario& scenario) {
  std::vector<Pose> rests;
  for (const ScenarioTool& tool : scenario.tools) rests.push_back(tool.rest);
  return rests;
}

// Boxes of slices along the mesh's axis: a slanted long object fills little of its own box.
std::vector<Aabb> slicesOf(const TriangleMesh& mesh) {
  constexpr int kSlices = 8;
  const Aabb whole = bounds(mesh);
  std::vector<Aabb> slices(kSlices);
  const auto sliceOf = [&](const Vec3& p) {
    const double share = (p.z() - whole.min.z()) / std::max(whole.size().z(), 1e-9);
    return std::clamp(int(share * kSlices), 0, kSlices - 1);
  };
  for (const Triangle& t : mesh.triangles) {
    Aabb box;
    for (const std::int32_t v : t) box.grow(mesh.points[std::size_t(v)]);
    const int last = sliceOf(box.max);
    for (int s = sliceOf(box.min); s <= last; ++s) {
      // A triangle counts in every slice that it crosses, with its part there.
      Aabb part = box;
      part.min.z() = std::max(box.min.z(), whole.min.z() + s * whole.size().z() / kSlices);
      part.max.z() = std::min(box.max.z(), whole.min.z() + (s + 1) * whole.size().z() / kSlices);
      slices[std::size_t(s)].grow(part);
    }
  }
  std::erase_if(slices, [](const Aabb& slice) { return slice.empty(); });
  return slices;
}

Vec3 positionOf(const SoPerspectiveCamera* camera) {
  const SbVec3f p = camera->position.getValue();
  return {p[0], p[1], p[2]};
}

// Unit.
Vec3 towards(const SoPerspectiveCamera* camera) {
  SbVec3f back;
  camera->orientation.getValue().multVec(SbVec3f(0, 0, 1), back);
  return {back[0], back[1], back[2]};
}

Aabb boxOfOrgans(const Simulation& simulation) {
  Aabb box;
  for (const OperatedOrgan& o : simulation.organs()) box.grow(o.organ.rest.lattice.box());
  return box;
}

}  // namespace

OperatingSession::OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation,
                                   double aspect, OperationWatch watch,
                                   std::optional<OperationHistory> history, bool paused)
    : scenario_(scenario),
      toolModels_(modelsOf(*simulation)),
      cells_(simulation->organ().rest),
      organBox_(boxOfOrgans(*simulation)),
      view_(scenario, *simulation, aspect),
      tools_(view_.room(), restsOf(scenario)),
      camera_(view_.room().camera()),
      iso_(view_.room().aids(), scaleFoot(organBox_, towardsCamera(RoomView::Surgeon))),
      marker_(view_.room().aids()),
      aim_(view_.room().aids(), {2.5f, false, 0}),
      bleeding_(view_.room().aids(), {}),
      guideMarks_(view_.room().aids(), {}),
      ghosts_(view_.room().aids(), scenario_, toolModels_),
      events_(SbViewportRegion(640, 480)),
      ledger_(scenario, *simulation),
      operation_(std::move(simulation), restsOf(scenario), scenario.frameRate, std::move(watch),
                 std::move(history), std::move(ledger_), paused) {
  for (const ToolModel& model : toolModels_) toolSlices_.push_back(slicesOf(model.mesh));
  if (scenario.mode == OperationMode::Operation)
    tools_.guide(toolModels_, cells_.lattice.spacing.maxCoeff());
  tools_.changed = [this] { handMoved(); };
  tools_.released = [this] { operation_.endStroke(); };
  tools_.readyPlace = Vec3(organBox_.centre().x(), organBox_.max.y() + 0.02,
                           organBox_.centre().z() + 0.15 * organBox_.size().z());
  tools_.constrain = [this](int tool, const Pose& pose) {
    double lowest = 0;
    for (const Vec3& p : toolModels_[std::size_t(tool)].mesh.points)
      lowest = std::min(lowest, (pose * p).y());
    return Pose{pose.position - Vec3(0, lowest, 0), pose.rotation};
  };
  iso_.setValue(scenario.organs[0].source.settings.iso);
  iso_.changed = [this](float iso) { setIso(iso); };
  camera_.pointUnder = [this](const SbVec2s& pixel, const SbViewportRegion& viewport) {
    const auto under = pointUnder(pixel, viewport);
    return under ? std::optional(under->point) : std::nullopt;
  };
  toolsChanged();
  keepAboveWall();
  measureField();
  look(RoomView::Surgeon, aspect);
}

// The silhouette is the sum of the triangles that face the surgeon; where the surface lies behind
// itself it counts twice.
void OperatingSession::measureField() {
  const Vec3 direction = towardsCamera(RoomView::Surgeon);
  for (int o = 0; o < room().organCount(); ++o) {
    const SurfaceCopy surface = room().organ(o)->snapshot().first;
    for (const Triangle& t : surface.triangles) {
      const Vec3 a = surface.points[std::size_t(t[0])].cast<double>(),
                 b = surface.points[std::size_t(t[1])].cast<double>(),
                 c = surface.points[std::size_t(t[2])].cast<double>();
      const double area = 0.5 * (b - a).cross(c - a).dot(direction);
      if (area <= 0) continue;
      fieldArea_ += area;
      fieldMiddle_ += area / 3 * (a + b + c);
    }
  }
  if (fieldArea_ > 0) fieldMiddle_ /= fieldArea_;
}

Vec3 OperatingSession::lampPosition() const {
  const SbVec3f p = room().lamp(0)->location.getValue();
  return {p[0], p[1], p[2]};
}

// By a hand that works with an instrument, an operation goes on from the moment that is shown.
void OperatingSession::handMoved() {
  if (following_) return toolsChanged();
  const bool hovers = tools_.how() == ToolHandling::Hold::Guided && !tools_.pressing();
  if (!hovers) goOn();
  // A tool that hovers is where the hand is; one that works is where the operation has brought it.
  if (hovers && state_.playback == 0)
    room().setToolPose(tools_.held(), tools_.wanted(tools_.held()));
  toolsChanged();
}

void OperatingSession::goOn() {
  if (!state_.showing || asked_ > state_.answered) return;
  operation_.goOn();
  goingOn_ = true;
  toolsChanged();
}

void OperatingSession::setIso(float iso) {
  goOn();
  iso_.setValue(iso);
  operation_.setIso(iso);
  damage_.everything = true;
}

// Tells the operation where the hand has the tools and which of them work.
void OperatingSession::setTools() {
  constexpr double kFastest = 0.3;  // m/s, of a hand that works
  for (int i = 0; i < tools_.toolCount(); ++i) {
    const bool held = i == tools_.held();
    const bool guided = held && tools_.how() == ToolHandling::Hold::Guided;
    const bool works = held ? !guided || tools_.pressing() : tools_.isLeft(i);
    const ToolInput input{tools_.wanted(i), works, held && !tools_.squeezing() ? 0.0 : 1.0,
                          held && tools_.pedalling() ? 1.0 : 0.0};
    if (guided && works)
      operation_.setTool(i, input, HandMotion{tools_.pressedFrom(), kFastest});
    else
      operation_.setTool(i, input);
  }
}

void OperatingSession::toolsChanged() {
  if (tools_.held() >= 0 && !following_) stopPlaying(), playedOut_ = false;
  toolBoxes_.resize(std::size_t(tools_.toolCount()));
  shownSlices_.resize(toolBoxes_.size()), shownHands_.resize(toolBoxes_.size());
  // While a moment is shown, the operation decides where the tools are.
  if (!showing()) setTools();
  for (int i = 0; i < tools_.toolCount(); ++i) {
    const Aabb hand = room().handBounds(i);
    if (Aabb& shown = shownHands_[std::size_t(i)]; hand.min != shown.min || hand.max != shown.max) {
      damage_.boxes.insert(damage_.boxes.end(), {hand, shown});
      shown = hand;
    }
    const Aabb box = room().toolBounds(i);
    Aabb& before = toolBoxes_[std::size_t(i)];
    if (box.min == before.min && box.max == before.max) continue;
    room().changedIn(before);
    room().changedIn(box);
    before = box;
    // A manipulator fills its box.
    std::vector<Aabb> slices{box};
    if (i != tools_.held() || tools_.how() == tools_.usual()) {
      slices = toolSlices_[std::size_t(i)];
      for (Aabb& slice : slices) slice = movedBox(slice, tools_.pose(i));
    }
    for (const std::vector<Aabb>& places : {shownSlices_[std::size_t(i)], slices})
      for (const Aabb& place : places) addWithShadow(damage_, place, lampPosition(), organBox_);
    shownSlices_[std::size_t(i)] = slices;
  }
  const SurfaceHand* hand = playing_ ? nullptr : tools_.surfaceHand();
  damage_.boxes.push_back(aim_.show(hand ? aimLines(*hand) : std::vector<MarkLine>()));
  if (tools_.held() < 0 || tools_.surfaceHand()) {
    marker_.hide();
    damage_.boxes.push_back(std::exchange(markerBox_, {}));
  }
}

bool OperatingSession::handle(const SoEvent& event, const SbViewportRegion& viewport) {
  // While an instrument follows the pointer, a drag of the camera is the camera's until its end.
  if (tools_.how() != ToolHandling::Hold::Guided || !camera_.dragging()) {
    events_.setViewportRegion(viewport);
    events_.setEvent(&event);
    events_.apply(root());
    // A dragger is highlighted under the pointer.
    if (events_.getGrabber()) damage_.everything = true;
    if (events_.isHandled()) return true;
  }
  if (camera_.handle(event, viewport)) {
    placeScale();
    tools_.aimAgain();
    damage_.everything = true;
    return true;
  }
  return tools_.surfaceHand() && event.isOfType(SoLocation2Event::getClassTypeId());
}

Damage OperatingSession::update() {
  SoSensorManager* sensors = SoDB::getSensorManager();
  sensors->processTimerQueue();
  sensors->processDelayQueue(TRUE);

  std::vector<SurfaceUpdate> updates;
  if (operation_.take(updates, state_)) {
    view_.follow(updates);
    followBlood();
    showBleeding();
    showGuide();
    Aabb changed;
    std::vector<Aabb> parts;
    double speed = 0;  // m/s
    for (int o = 0; o < room().organCount(); ++o) {
      for (const Aabb& part : room().organ(o)->takeChanged()) {
        parts.push_back(part);
        changed.grow(part);
      }
      speed = std::max(speed, room().organ(o)->takeSpeed());
    }
    const bool everything = std::ranges::any_of(updates, &SurfaceUpdate::everything);
    if (everything) damage_.everything = true;
    if (everything) room().changedIn({});
    if (!everything && !changed.empty()) {
      room().changedIn(changed);
      if (speed < kSlow)
        damage_.slow.grow(changed);
      else
        for (const Aabb& part : parts) addWithShadow(damage_, part, lampPosition(), organBox_);
    }
    bool turned = false;
    for (int i = 0; i < tools_.toolCount() && std::size_t(i) < state_.bloody.size(); ++i)
      room().setToolBlood(i, state_.bloody[std::size_t(i)]);
    for (int i = 0; i < tools_.toolCount(); ++i)
      turned |= room().setToolSqueeze(i, state_.squeeze[std::size_t(i)]);
    if (turned) toolsChanged();
    if (!state_.showing) goingOn_ = false;
    if (state_.showing && !goingOn_)
      followMoment();
    else if (playing_)
      followMotion();
    else
      followHand();
    const int held = tools_.held();
    if (held >= 0 && !tools_.surfaceHand() && std::size_t(held) < state_.tips.size()) {
      const TipPlace& place = state_.tips[std::size_t(held)];
      const Vec3 tip = tools_.pose(held) * toolModels_[std::size_t(held)].tip;
      Aabb box;
      box.grow(tip);
      box.grow(Vec3(tip.x(), std::min(place.below, tip.y()), tip.z()));
      box = box.padded(0.008);
      if (marker_.show(tip, place.below, place.distance, state_.touching[std::size_t(held)] != 0)) {
        damage_.boxes.push_back(markerBox_);
        damage_.boxes.push_back(box);
      }
      markerBox_ = box;
    }
  }
  std::erase_if(damage_.boxes, [](const Aabb& box) { return box.empty(); });
  return std::exchange(damage_, {});
}

void OperatingSession::follow(const ViewMotion& motion) {
  if (motion.move.isZero() && motion.turn.isZero()) return;
  if (tools_.held() >= 0) {
    if (tools_.how() == ToolHandling::Hold::Guided)
      tools_.hold(tools_.held(), ToolHandling::Hold::Direct);
    if (!motion.move.isZero()) tools_.move(motion.move);
    tools_.turn(motion.turn);
    return;
  }
  const double distance = (camera_.pointOfInterest() - positionOf(room().camera())).norm();
  camera_.pan(motion.move.x(), motion.move.y());
  camera_.zoom(std::exp(motion.move.z() / std::max(distance, 0.05)));
  camera_.orbit(motion.turn.y(), -motion.turn.x());
  placeScale();
  damage_.everything = true;
}

void OperatingSession::look(RoomView view, double aspect) {
  constexpr double kShare = 0.5, kSmall = 0.08;  // of the picture; m: an organ that is seen whole
  if (view != RoomView::Surgeon && view == roomView(scenario_.view))
    room().frame(view, scenario_.closeUp.value_or(organBox_), aspect);
  else if (view != RoomView::Surgeon)
    room().look(view, organBox_, aspect);
  else if (scenario_.mode == OperationMode::Thesis || fieldArea_ <= 0)
    room().frame(view, allThereIs(towardsCamera(view)), aspect);
  else if (!showsField(scenario_) && 0.5 * organBox_.size().norm() < kSmall)
    room().frame(view, organBox_, aspect);
  else
    room().closeUp(view, fieldMiddle_, fieldArea_, kShare, aspect);
  placeScale();
  tools_.aimAgain();
  damage_.everything = true;
}

// In the field the camera does not go behind the abdominal wall.
void OperatingSession::keepAboveWall() { camera_.lowest = showsField(scenario_) ? 0.35 : -0.2; }

void OperatingSession::showField(bool field) {
  scenario_.setting = field ? "field" : "table";
  view_.showField(showsField(scenario_));
  keepAboveWall();
  damage_.everything = true;
}

void OperatingSession::showHands(bool shown) {
  room().showHands(shown);
  damage_.everything = true;
}

void OperatingSession::viewAll(double aspect) {
  room().viewAll(allThereIs(towards(room().camera())), aspect);
  damage_.everything = true;
}

void OperatingSession::zoom(double factor) {
  camera_.zoom(factor);
  tools_.aimAgain();
  damage_.everything = true;
}

void OperatingSession::placeScale() { iso_.moveTo(scaleFoot(organBox_, towards(room().camera()))); }

void OperatingSession::showScale(bool shown) {
  if (shown == iso_.shown()) return;
  iso_.show(shown);
  damage_.everything = true;
}

// Bounds of the organs, the tools at rest if they are shown and, unless it is hidden, the scale of
// the iso level.
Aabb OperatingSession::allThereIs(const Vec3& towardsCamera) const {
  Aabb all = organBox_;
  if (!showsField(scenario_))
    for (std::size_t i = 0; i < toolModels_.size(); ++i)
      for (const Vec3& p : toolModels_[i].mesh.points) all.grow(scenario_.tools[i].rest * p);
  if (iso_.shown()) all.grow(Vec3(scaleFoot(organBox_, towardsCamera) - Vec3(0.01, 0, 0)));
  return all;
}

void OperatingSession::bringEverythingBack(double aspect) {
  stopPlaying();
  for (int i = 0; i < tools_.toolCount(); ++i) tools_.putBack(i);
  look(RoomView::Surgeon, aspect);
}

}  // namespace resect
