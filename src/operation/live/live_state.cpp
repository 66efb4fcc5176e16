#include "operation/live/live_state.h"

#include <algorithm>

#include "operation/blood/bleeding_ends.h"

namespace resect {

namespace {

void noteBlood(LiveState& state, const Simulation& simulation, const StepReport& report) {
  constexpr double kMeanTime = 1;  // s
  state.bleeds = simulation.blood().any();
  if (!state.bleeds) return;
  const double before = state.bled;
  state.bled = toCubicMetres(simulation.blood().ledger().bled);
  const double share = std::min(1.0, std::max(0.0, report.time - state.bloodTime) / kMeanTime);
  state.bloodTime = report.time;
  if (state.bled < before) state.bleedingRate = 0;  // another moment
  state.bleedingRate += share * (report.blood.rate - state.bleedingRate);
  state.loose = looseBlood(simulation.blood());
  state.bare = bareVessels(simulation);
  state.bleedingEnds = bleedingEnds(simulation);
  state.air = simulation.blood().air();
  followBlood(simulation, state.bloody);
  state.clips.clear();
  state.inflowClamped = false, state.clampedTime = 0;
  for (std::size_t o = 0; o < simulation.organs().size(); ++o) {
    const Organ& organ = simulation.organs()[o].organ;
    state.inflowClamped = state.inflowClamped || organ.vessels.inflowClamped;
    state.clampedTime = std::max(state.clampedTime, organ.vessels.clampedTime);
    for (const VesselClip& clip : organ.vessels.clips)
      if (!clip.byHeat)
        state.clips.push_back({std::int32_t(o), clip.segment,
                               organ.map->anatomy.segments[std::size_t(clip.segment)].radius});
  }
}

}  // namespace

void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before, const std::vector<double>& peaks) {
  constexpr double kTouchShows = 0.1;    // s: removed tissue is in contact for one frame only
  constexpr double kFeltContact = 0.01;  // N
  constexpr double kMoved = 1e-5;        // m
  followSmoke(state.smoke, report.smoke, report.time, report.time - state.time);
  state.frame = report.frame + 1;
  state.time = report.time;
  std::int64_t removed = 0;
  state.particles = state.triangles = 0;
  state.removedVolume = 0;
  for (const OperatedOrgan& o : simulation.organs()) {
    state.particles += o.organ.particles;
    removed += o.organ.removed;
    state.removedVolume += o.organ.removedVolume;
    state.triangles += o.organ.surface.triangleCount();
  }
  if (removed != state.removed) state.lastRemoval = steadySeconds();
  state.removed = removed;
  state.volume = before - state.removedVolume;
  state.iso = simulation.organ().iso;
  noteBlood(state, simulation, report);
  state.moves = simulation.moves();
  state.canBreathe = simulation.breathing().depth > 0;
  state.breathes = state.canBreathe && simulation.breath().on;
  for (const std::string& fault : report.faults)
    if (std::ranges::find(state.faults, fault) == state.faults.end()) state.faults.push_back(fault);

  const std::vector<ToolState>& tools = simulation.tools();
  state.poses.resize(tools.size());
  state.inHand.resize(tools.size());
  state.moved.resize(tools.size());
  state.tips.resize(tools.size());
  state.squeeze.resize(tools.size());
  state.forces.resize(tools.size());
  state.peakForces = peaks;
  state.peakForces.resize(tools.size());
  state.lastTouch.resize(tools.size(), -1);
  state.touching.resize(tools.size());
  state.grips.resize(tools.size());
  const std::size_t organs = simulation.organs().size();
  for (std::size_t i = 0; i < tools.size(); ++i) {
    state.poses[i] = tools[i].pose();
    state.inHand[i] = tools[i].inHand;
    const ToolWay& way = tools[i].way;
    state.moved[i] = (way.to.pose.position - way.from.pose.position).norm() > kMoved;
    state.squeeze[i] = tools[i].way.to.squeeze;
    state.forces[i] = tools[i].feltForce.norm();
    double& touch = state.lastTouch[i];
    bool touches = report.toolForce[i].norm() > kFeltContact;
    for (std::size_t o = 0; o < organs; ++o)
      touches = touches || !report.contacts[i * organs + o].cells.empty();
    if (touches) touch = report.time;
    state.grips[i] = std::ranges::any_of(simulation.organs(), [&](const OperatedOrgan& organ) {
      return organ.tissue->gripped(std::int32_t(i)) > 0;
    });
    state.touching[i] = std::uint8_t(touch >= 0 && report.time - touch < kTouchShows);
    if (!tools[i].inHand) continue;
    const Vec3 tip = tools[i].pose() * tools[i].tool->model.tip;
    TipPlace& place = state.tips[i] = placeOf(presentSurface(simulation), tip);
    for (std::size_t o = 1; o < organs; ++o) {
      const TipPlace other = placeOf(presentSurface(simulation, o), tip);
      place = {std::max(place.below, other.below), std::min(place.distance, other.distance)};
    }
  }
}

void noteMoment(LiveState& state, const Simulation& simulation, double before,
                const std::vector<double>& peaks) {
  StepReport report;
  report.frame = simulation.frame() - 1;
  report.time = simulation.time();
  report.toolForce.assign(simulation.tools().size(), Vec3::Zero());
  report.contacts.resize(simulation.tools().size() * simulation.organs().size());
  for (const BleedingEnd& end : bleedingEnds(simulation))
    report.blood.rate += std::max(0.0, end.flow);
  state.lastTouch.clear();
  state.bloody.clear();
  state.smoke = {};
  noteStep(state, simulation, report, before, peaks);
  state.bleedingRate = report.blood.rate;  // there is no second before it to take the mean of
}

}  // namespace resect
