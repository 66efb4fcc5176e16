#include "operation/live/live_state.h"

namespace resect {

void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before) {
  constexpr double kTouchShows = 0.1;    // s: tissue that is taken at once is touched for a frame
  constexpr double kFeltContact = 0.01;  // N
  const Organ& organ = simulation.organ();
  state.frame = report.frame + 1;
  state.time = report.time;
  state.particles = organ.particles;
  if (organ.removed != state.removed) state.lastRemoval = steadySeconds();
  state.removed = organ.removed;
  state.removedVolume = organ.removedVolume;
  state.volume = before - organ.removedVolume;
  state.triangles = organ.surface.triangleCount();
  state.iso = organ.surface.iso();
  state.moves = simulation.tissue().moves();
  state.faults = report.faults;

  const std::vector<ToolState>& tools = simulation.tools();
  state.tips.resize(tools.size());
  state.squeeze.resize(tools.size());
  state.forces.resize(tools.size());
  state.lastTouch.resize(tools.size(), -1);
  state.touching.resize(tools.size());
  const PresentSurface surface = presentSurface(simulation);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    state.squeeze[i] = tools[i].way.to.squeeze;
    state.forces[i] = tools[i].feltForce.norm();
    double& touch = state.lastTouch[i];
    if (!report.contacts[i].cells.empty() || report.toolForce[i].norm() > kFeltContact)
      touch = report.time;
    state.touching[i] = std::uint8_t(touch >= 0 && report.time - touch < kTouchShows);
    if (tools[i].inHand)
      state.tips[i] = placeOf(surface, tools[i].pose() * tools[i].tool->model.tip);
  }
}

}  // namespace resect
