#include "inventor/scene/operation_view.h"

#include <algorithm>

#include "base/error.h"
#include "inventor/gl/SoOrganShape.h"
#include "operation/blood/bare_vessels.h"
#include "operation/blood/bloody_tools.h"
#include "operation/blood/loose_blood.h"
#include "operation/room.h"

namespace resect {

Vec3f organColour(const OrganSource& organ) {
  return organ.file == "gallbladder" ? kGallbladderColour : kLiverColour;
}

OperationView::OperationView(const Scenario& scenario, Simulation& simulation, double aspect)
    : smokes_(scenario.mode != OperationMode::Thesis),
      table_(scenario.table),
      toolBox_(scenario.toolBox) {
  const auto view = roomView(scenario.view);
  if (!view)
    throw usageError("there is no view \"{}\"; use surgeon, assistant, top or laparoscope",
                     scenario.view);
  for (const ToolState& state : simulation.tools()) room_.addTool(state.tool->model);
  simulation.keepLook();
  publishers_.assign(simulation.organs().size(), SurfacePublisher(0));
  room_.setOrganColour(organColour(scenario.organs[0].source));
  for (std::size_t o = 1; o < simulation.organs().size(); ++o)
    room_.addOrgan(organColour(scenario.organs[o].source));
  follow(simulation);
  for (const ScenarioTool& tool : scenario.tools) rests_.push_back(tool.rest);
  if (simulation.frame() == 0)  // no frame has placed the tools yet
    for (std::size_t i = 0; i < rests_.size(); ++i) room_.setToolPose(int(i), rests_[i]);
  for (const OperatedOrgan& o : simulation.organs()) organs_.grow(o.organ.rest.lattice.box());
  showField(showsField(scenario));
  Aabb box = organs_;
  // Includes the table below, since hanging or falling tissue may reach it.
  if (scenario.table) box.min.y() = std::min(box.min.y(), 0.0);
  room_.lightUp(box);
  if (scenario.closeUp)
    room_.frame(*view, *scenario.closeUp, aspect);
  else
    room_.look(*view, box, aspect);
}

void OperationView::showField(bool field) {
  room_.setTable(table_ && !field ? readRoomModel("table") : nullptr);
  room_.setToolbox(toolBox_ && !field ? toolPlaces(rests_.size()) : nullptr);
  room_.setField(field ? readRoomModel("field") : nullptr, organs_);
  for (std::size_t i = 0; i < rests_.size(); ++i)
    room_.hideAtRest(int(i), field ? std::optional(rests_[i]) : std::nullopt);
}

RgbImage OperationView::draw(OffscreenView& picture) const { return picture.render(room_.root()); }

void OperationView::follow(const Simulation& simulation) {
  followBlood(simulation, bloody_);
  for (std::size_t i = 0; i < simulation.tools().size(); ++i) {
    room_.setToolPose(int(i), simulation.tools()[i].pose());
    room_.setToolSqueeze(int(i), simulation.tools()[i].way.to.squeeze);
    room_.setToolBlood(int(i), bloody_[i]);
  }
  std::vector<SurfaceUpdate> updates;
  for (std::size_t o = 0; o < publishers_.size(); ++o) {
    publishers_[o].follow(presentSurface(simulation, o));
    updates.push_back(publishers_[o].take());
  }
  follow(updates);
  room_.setLooseBlood(looseBlood(simulation.blood()).get());
  room_.setBareVessels(bareVessels(simulation).get());
  room_.setAdnexa(adnexa_.follow(simulation).get());
}

void OperationView::followSmoke(const StepReport& step) {
  if (!smokes_) return;
  const double duration = step.time - smokeTime_;
  smokeTime_ = step.time;
  resect::followSmoke(smoke_, step.smoke, step.time, duration);
  room_.setSmoke(smokeBalls(smoke_, step.time));
}

void OperationView::follow(std::span<const SurfaceUpdate> updates) {
  for (std::size_t o = 0; o < updates.size(); ++o) room_.organ(int(o))->update(updates[o]);
}

}  // namespace resect
