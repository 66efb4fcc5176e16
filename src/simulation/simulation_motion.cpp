// The motion of tissue in a simulation: breathing, and what motion causes. Obstacles:
// simulation_surroundings.cpp.
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "organ/vessel_cords.h"
#include "simulation/simulation.h"

namespace resect {
namespace {

constexpr double kFeltTime = 0.05;  // s: time constant of the force that a hand feels

}  // namespace

void Simulation::setBreathing(const Breathing& breathing) {
  require(breathing.depth >= 0 && std::isfinite(breathing.depth) && breathing.perMinute > 0 &&
              std::isfinite(breathing.perMinute) && breathing.bed >= 0 && breathing.bed <= 1,
          "breathing is {} m deep, {} times a minute, with a share of {} for the bed; give a depth "
          "from 0, a rate above 0 and a share from 0 to 1",
          breathing.depth, breathing.perMinute, breathing.bed);
  if (!moves()) return;
  breathing_ = breathing;
  breath_.on = breathing.begins;
}

// Moves the holds of moving tissue, and the table, by breathing.
void Simulation::moveHolds(const FrameInput& input) {
  if (!(breathing_.depth > 0)) return;
  if (input.breathes) breath_.on = *input.breathes;
  if (!(input.duration > 0)) return;
  const BreathMotion motion = breathe(breathing_, breath_, input.duration);
  work_.table = {breathing_.bed * motion.displacement(0), breathing_.bed * motion.displacement(1)};
  for (OperatedOrgan& o : organs_) o.tissue->moveHolds(motion);
}

// Moves the tissue for the frame, with the moving tools as obstacles, and lets edges cut. What this
// causes is queued.
void Simulation::moveTissue(const FrameInput& input, StepReport& report) {
  report.toolForce.assign(tools_.size(), Vec3::Zero());
  report.tissue.resize(organs_.size());
  for (TissueStep& step : report.tissue) step.forget();
  work_.caused.clear();
  moveHolds(input);
  listMoving(input, report);
  if (work_.moving.empty()) return;
  findJoined();
  moveTissues(work_.moving, joints_, joined_, input.duration);

  for (std::size_t o = 0; o < organs_.size(); ++o) {
    const TissueStep& step = report.tissue[o];
    for (const TissueCut& cut : step.cuts)
      work_.caused.push_back({std::int32_t(o), cut.tool, Incision{cut.blade}});
    if (!organs_[o].tissue->moves()) continue;
    for (std::size_t k = 0; k < work_.obstacles[o].size(); ++k)
      if (const std::int32_t tool = work_.obstacles[o][k].tool; tool >= 0)
        report.toolForce[std::size_t(tool)] += step.force[k];
    for (const std::int32_t tool : step.letGo)
      work_.caused.push_back({std::int32_t(o), tool, Release{}});
    for (const TissueBond& bond : step.torn)
      work_.caused.push_back(
          {std::int32_t(o), -1, TearBond{bond.cell, bond.direction, kTornVessel}});
    for (const DivideVessel& vessel : brokenVessels(organs_[o]))
      work_.caused.push_back({std::int32_t(o), -1, vessel});
    if (!step.calm)
      report.faults.emplace_back(
          "the tissue exploded and was stopped for a frame; make it softer, its cells larger or "
          "the tool slower");
  }
  const double share = 1 - math::exp(-input.duration / kFeltTime);
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    tools_[i].force = report.toolForce[i];
    tools_[i].feltForce += share * (tools_[i].force - tools_[i].feltForce);
  }
}

}  // namespace resect
