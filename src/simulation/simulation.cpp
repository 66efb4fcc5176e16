#include "simulation/simulation.h"

#include <cmath>

#include "base/assert.h"
#include "base/state_hash.h"

namespace resect {

Simulation::Simulation(Organ organ, std::vector<std::unique_ptr<Tool>> tools)
    : organ_(std::move(organ)) {
  for (auto& tool : tools) tools_.push_back({std::move(tool), {}, {}, false, false});
}

StepReport Simulation::step(const FrameInput& input, StageClock* clock) {
  StepReport report;
  step(input, report, clock);
  return report;
}

void Simulation::step(const FrameInput& input, StepReport& report, StageClock* clock) {
  const auto done = [&](const char* stage) {
    if (clock) clock->lap(stage);
  };
  if (clock) clock->start();

  moveTools(input, report);
  done("moveTools");
  findContacts(report);
  done("findContacts");
  actTools(report);
  done("actTools");
  applyEdits(report);
  done("applyEdits");
  updateField(report);
  done("updateField");
  updateSurface(input);
  done("updateSurface");
  measure(input, report);
  done("measure");
}

// Tools go to their new poses. One that was just taken in hand starts there: it swept nothing on
// its way.
void Simulation::moveTools(const FrameInput& input, StepReport& report) {
  RESECT_ASSERT(input.tools.size() == tools_.size());
  report.faults.clear();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    ToolState& state = tools_[i];
    const ToolInput& wanted = input.tools[i];
    if (!wanted.pose.position.allFinite() || !wanted.pose.rotation.coeffs().allFinite()) {
      report.faults.push_back("the pose of tool \"" + state.tool->model().name +
                              "\" is not a number; it stays where it was: check the tool's motion");
      continue;
    }
    state.wasInHand = state.inHand;
    state.inHand = wanted.inHand;
    state.previousPose = state.wasInHand ? state.pose : wanted.pose;
    state.pose = wanted.pose;
  }
}

// Which particles does each tool in hand sweep over?
void Simulation::findContacts(StepReport& report) const {
  report.contacts.resize(tools_.size());
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolState& state = tools_[i];
    if (state.inHand)
      report.contacts[i] = resect::findContacts(organ_, *state.tool, std::int32_t(i),
                                                state.previousPose, state.pose);
    else
      report.contacts[i] = {std::int32_t(i), {}, 0, {}};
  }
}

// Each tool turns what it touches into edits; nothing changes yet.
void Simulation::actTools(const StepReport& report) {
  edits_.clear();
  for (const ToolContacts& contacts : report.contacts)
    if (!contacts.cells.empty()) tools_[contacts.tool].tool->act(contacts, edits_);
}

// The only place where tissue is changed by tools.
void Simulation::applyEdits(StepReport& report) {
  const EditSummary summary = resect::applyEdits(organ_, edits_);
  report.removed = summary.removed;
  report.removedVolume = summary.removedVolume;
}

// Bricks of the colour field that the edits reach are evaluated again.
void Simulation::updateField(StepReport& report) {
  touchedBricks_ = resect::updateField(organ_);
  report.touchedBricks = std::int64_t(touchedBricks_.size());
}

// The same bricks are meshed again; all of them when the iso level changed.
void Simulation::updateSurface(const FrameInput& input) {
  if (input.iso && *input.iso >= kMinIso && *input.iso <= kMaxIso &&
      *input.iso != organ_.surface.iso())
    setIso(organ_, *input.iso);
  else
    resect::updateSurface(organ_, touchedBricks_);
}

// The books: time, frame, and faults of nature or of settings.
void Simulation::measure(const FrameInput& input, StepReport& report) {
  if (input.iso && !(*input.iso >= kMinIso && *input.iso <= kMaxIso))
    report.faults.push_back("iso level " + std::to_string(*input.iso) + " is outside " +
                            std::to_string(int(kMinIso)) + " to " + std::to_string(int(kMaxIso)) +
                            "; the level stays as it was");
  time_ += input.duration;
  report.frame = frame_++;
  report.time = time_;
}

std::uint64_t Simulation::stateHash() const {
  StateHash hash;
  hash.add(frame_);
  hash.add(time_);
  hash.addSpan(std::span<const std::uint8_t>(organ_.alive));
  for (std::int64_t cell = 0; cell < organ_.rest.lattice.cellCount(); ++cell)
    hash.add(organ_.field.cellValue(cell));
  hash.add(organ_.surface.iso());
  const auto surface = organ_.surface.compact();
  hash.addSpan(std::span<const Vec3>(surface.mesh.points));
  hash.addSpan(std::span<const Triangle>(surface.mesh.triangles));
  hash.addSpan(std::span<const Vec3f>(surface.normals));
  for (const ToolState& state : tools_) {
    hash.addBytes(state.pose.position.data(), 3 * sizeof(double));
    hash.addBytes(state.pose.rotation.coeffs().data(), 4 * sizeof(double));
    hash.add(std::uint8_t(state.inHand));
  }
  return hash.value();
}

}  // namespace resect
