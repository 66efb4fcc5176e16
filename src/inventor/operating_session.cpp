#include "inventor/operating_session.h"

#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/sensors/SoSensorManager.h>

#include <utility>

#include "operation/room.h"

namespace resect {
namespace {

std::vector<ToolModel> modelsOf(const Simulation& simulation) {
  std::vector<ToolModel> models;
  for (const ToolState& state : simulation.tools()) models.push_back(state.tool->model());
  return models;
}

std::vector<Pose> restsOf(const Scenario& scenario) {
  std::vector<Pose> rests;
  for (const ScenarioTool& tool : scenario.tools) rests.push_back(tool.rest);
  return rests;
}

// At the far left corner of the table's field, where it hides nothing.
Vec3 isoFoot(const Aabb& organ) {
  return {organ.min.x() - 0.06, 0.0, organ.min.z() + 0.25 * organ.size().z()};
}

}  // namespace

OperatingSession::OperatingSession(const Scenario& scenario, std::unique_ptr<Simulation> simulation,
                                   double aspect)
    : scenario_(scenario),
      toolModels_(modelsOf(*simulation)),
      cells_(simulation->organ().rest),
      organBox_(cells_.lattice.box()),
      view_(scenario, *simulation, aspect),
      tools_(view_.room(), restsOf(scenario)),
      camera_(view_.room().camera()),
      iso_(view_.room().aids(), isoFoot(organBox_)),
      marker_(view_.room().aids()),
      events_(SbViewportRegion(640, 480)),
      operation_(std::move(simulation), restsOf(scenario), scenario.frameRate) {
  tools_.changed = [this] { toolsChanged(); };
  iso_.setValue(scenario.organ.settings.iso);
  iso_.changed = [this](float iso) {
    operation_.setIso(iso);
    dirty_ = true;
  };
  toolsChanged();
  look(RoomView::Surgeon, aspect);
}

void OperatingSession::toolsChanged() {
  for (int i = 0; i < tools_.toolCount(); ++i)
    operation_.setTool(i, {tools_.pose(i), i == tools_.held()});
  if (tools_.held() < 0) marker_.hide();
  dirty_ = true;
}

bool OperatingSession::handle(const SoEvent& event, const SbViewportRegion& viewport) {
  events_.setViewportRegion(viewport);
  events_.setEvent(&event);
  events_.apply(root());
  const bool taken = events_.isHandled() || camera_.handle(event, viewport);
  if (taken) dirty_ = true;
  return taken;
}

bool OperatingSession::update() {
  SoSensorManager* sensors = SoDB::getSensorManager();
  sensors->processTimerQueue();
  sensors->processDelayQueue(TRUE);

  SurfaceUpdate update;
  bool redraw = std::exchange(dirty_, false);
  if (operation_.take(update, state_)) {
    view_.follow(update);
    redraw = redraw || !update.empty();
    const int held = tools_.held();
    if (held >= 0 && std::size_t(held) < state_.tips.size()) {
      const TipPlace& place = state_.tips[std::size_t(held)];
      marker_.show(tools_.pose(held) * toolModels_[std::size_t(held)].tip, place.below,
                   place.distance, state_.touching[std::size_t(held)] != 0);
    }
  }
  return redraw;
}

void OperatingSession::look(RoomView view, double aspect) {
  if (view != RoomView::Surgeon) {
    room().look(view, organBox_, aspect);
  } else {
    // The surgeon sees what there is to take.
    Aabb all = organBox_;
    for (std::size_t i = 0; i < toolModels_.size(); ++i)
      for (const Vec3& p : toolModels_[i].mesh.points) all.grow(scenario_.tools[i].rest * p);
    room().frame(view, all, aspect);
  }
  dirty_ = true;
}

void OperatingSession::bringEverythingBack(double aspect) {
  for (int i = 0; i < tools_.toolCount(); ++i) tools_.putBack(i);
  look(RoomView::Surgeon, aspect);
}

bool OperatingSession::pointUnder(const SbVec2s& pixel, const SbViewportRegion& viewport,
                                  Vec3& point) const {
  // The organ is left out of picking for speed's sake; here one ray may take its time.
  SbViewVolume volume = room().camera()->getViewVolume(viewport.getViewportAspectRatio());
  const SbVec2s size = viewport.getViewportSizePixels();
  SbVec3f from, towards;
  volume.projectPointToLine(SbVec2f(float(pixel[0]) / size[0], float(pixel[1]) / size[1]), from,
                            towards);
  const Vec3 origin(from[0], from[1], from[2]);
  const Vec3 way = Vec3(towards[0], towards[1], towards[2]) - origin;
  // Along the ray through the cells, in steps of half a cell.
  const Lattice& lattice = cells_.lattice;
  const double step = 0.5 * lattice.spacing.minCoeff(), length = std::min(way.norm(), 5.0);
  for (double t = 0; t < length; t += step) {
    const Vec3 p = origin + t * way.normalized();
    const Vec3i cell = lattice.toCellSpace(p).array().round().matrix().cast<int>();
    const bool tissue =
        lattice.contains(cell) && cells_.value[std::size_t(lattice.index(cell))] > 50;
    if (p.y() > 0 && !tissue) continue;
    point = p;
    return true;
  }
  return false;
}

SbVec2s OperatingSession::pixelOf(const Vec3& point, const SbViewportRegion& viewport) const {
  const SbViewVolume volume = room().camera()->getViewVolume(viewport.getViewportAspectRatio());
  SbVec3f screen;
  volume.projectToScreen(SbVec3f(float(point.x()), float(point.y()), float(point.z())), screen);
  const SbVec2s size = viewport.getViewportSizePixels();
  return {short(screen[0] * size[0]), short(screen[1] * size[1])};
}

Vec3 OperatingSession::middleOfTool(int tool) const {
  const Aabb box = bounds(toolModels_.at(std::size_t(tool)).mesh);
  return tools_.pose(tool) * box.centre();
}

}  // namespace resect
