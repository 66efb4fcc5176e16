#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/state_hash.h"
#include "organ/moved_incision.h"
#include "organ/strands.h"
#include "tissue/still_tissue.h"
#include "tools/moving_contacts.h"

namespace resect {

namespace {

constexpr double kFeltTime = 0.05;  // s: time constant of the force that a hand feels

}  // namespace

Simulation::Simulation(Organ organ, std::vector<std::unique_ptr<Tool>> tools,
                       std::unique_ptr<TissueModel> tissue, bool table)
    : organ_(std::move(organ)),
      tissue_(tissue ? std::move(tissue) : std::make_unique<StillTissue>()),
      table_(table) {
  for (auto& tool : tools) {
    tools_.emplace_back();
    tools_.back().tool = std::move(tool);
  }
  if (!tissue_->moves()) return;
  const double spacing = organ_.rest.lattice.spacing.x();
  for (const ToolState& state : tools_)
    shapes_.push_back(std::make_unique<SignedDistance>(state.tool->model().mesh, 2 * spacing,
                                                       std::clamp(spacing / 6, 0.0005, 0.002)));
  skin_.follow(organ_.surface, organ_.rest.lattice, *tissue_, {}, keepsLook_);
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
  moveTissue(input, report);
  done("moveTissue");
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
    state.earlierPose = state.wasInHand ? state.previousPose : wanted.pose;
    state.previousPose = state.wasInHand ? state.pose : wanted.pose;
    state.pose = wanted.pose;
    const double squeeze = std::isfinite(wanted.squeeze) ? std::clamp(wanted.squeeze, 0.0, 1.0) : 0;
    state.earlierSqueeze = state.wasInHand ? state.previousSqueeze : squeeze;
    state.previousSqueeze = state.wasInHand ? state.squeeze : squeeze;
    state.squeeze = squeeze;
  }
}

// Which particles does each tool in hand sweep over?
void Simulation::findContacts(StepReport& report) const {
  report.contacts.resize(tools_.size());
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolState& state = tools_[i];
    if (state.inHand && tissue_->moves())
      report.contacts[i] = findMovingContacts(organ_, *tissue_, *state.tool, std::int32_t(i),
                                              {{state.earlierPose, state.earlierSqueeze},
                                               {state.previousPose, state.previousSqueeze},
                                               {state.pose, state.squeeze}});
    else if (state.inHand)
      report.contacts[i] = resect::findContacts(organ_, *state.tool, std::int32_t(i),
                                                state.previousPose, state.pose);
    else
      (report.contacts[i] = {}).tool = std::int32_t(i);
  }
}

// Each tool turns what it touches into edits; nothing changes yet.
void Simulation::actTools(const StepReport& report) {
  edits_.clear();
  for (const ToolContacts& contacts : report.contacts)
    if (!contacts.cells.empty() || !contacts.nearBlade.empty() || !contacts.caught.empty())
      tools_[contacts.tool].tool->act(contacts, edits_);
  for (std::size_t i = 0; i < tools_.size(); ++i)
    if (!tools_[i].inHand && tools_[i].wasInHand)
      edits_.push_back({TissueEdit::Kind::Release, std::int32_t(i)});
}

// The only place where tissue is changed by tools.
void Simulation::applyEdits(StepReport& report) {
  const EditSummary summary = resect::applyEdits(organ_, edits_);
  report.removed = summary.removed;
  report.removedVolume = summary.removedVolume;
  report.severed = 0;
  changedCells_.clear();
  cutBonds_.clear();
  cutCells_.clear();
  if (!tissue_->moves()) return;
  for (const TissueEdit& edit : edits_) switch (edit.kind) {
      case TissueEdit::Kind::Remove:
        changedCells_.push_back(edit.cell);
        tissue_->remove(edit.cell);
        break;
      case TissueEdit::Kind::Incise:
        inciseMoved(organ_, *tissue_, report.contacts[edit.tool].blade,
                    report.contacts[edit.tool].nearBlade);
        cutCells_.insert(cutCells_.end(), report.contacts[edit.tool].nearBlade.begin(),
                         report.contacts[edit.tool].nearBlade.end());
        break;
      case TissueEdit::Kind::Sever:
        tissue_->sever(edit.cell, edit.direction);
        cutBonds_.push_back({edit.cell, edit.direction});
        break;
      case TissueEdit::Kind::Grip:
        tissue_->grip(edit.cell, edit.tool, tools_[edit.tool].previousPose);
        break;
      case TissueEdit::Kind::Release:
        tissue_->release(edit.tool);
        break;
    }
  partStrands(organ_, *tissue_, cutBonds_, cutCells_);
  report.severed = std::int64_t(cutBonds_.size());
}

// Tissue moves for the frame, pushed and pulled by the tools on their way.
void Simulation::moveTissue(const FrameInput& input, StepReport& report) {
  report.toolForce.assign(tools_.size(), Vec3::Zero());
  if (!tissue_->moves() || !(input.duration > 0)) return;
  const double spacing = organ_.rest.lattice.spacing.x();
  tissueTools_.clear();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolState& state = tools_[i];
    const ToolModel& model = state.tool->model();
    if (state.inHand)
      tissueTools_.push_back({std::int32_t(i),
                              model.response == "remove" ? nullptr : shapes_[i].get(),
                              state.previousPose, state.pose, standOff(model, spacing),
                              model.friction, model.slipForce});
  }
  tissue_->move(input.duration, {tissueTools_, table_}, report.tissue);
  partStrands(organ_, *tissue_, report.tissue.tornBonds);
  for (std::size_t k = 0; k < tissueTools_.size(); ++k)
    report.toolForce[tissueTools_[k].tool] = report.tissue.toolForce[k];
  const double share = 1 - std::exp(-input.duration / kFeltTime);
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    tools_[i].force = report.toolForce[i];
    tools_[i].feltForce += share * (tools_[i].force - tools_[i].feltForce);
  }
  if (!report.tissue.calm)
    report.faults.push_back(
        "the tissue exploded and was stopped for a frame; make it softer, its cells larger or the "
        "tool slower");
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
  if (keepsLook_) organ_.surface.updateLook(organ_.field);
  if (tissue_->moves())
    skin_.follow(organ_.surface, organ_.rest.lattice, *tissue_, changedCells_, keepsLook_);
}

void Simulation::keepLook() {
  keepsLook_ = true;
  organ_.surface.updateLook(organ_.field);
  if (tissue_->moves()) skin_.turnNormals(organ_.surface);
}

std::span<const Vec3f> Simulation::surfacePoints() const {
  return tissue_->moves() ? skin_.points() : organ_.surface.points();
}

std::span<const Vec3f> Simulation::surfaceNormals() const {
  return tissue_->moves() ? skin_.normals() : organ_.surface.normals();
}

TriangleMesh Simulation::surfaceMesh() const { return organ_.surface.mesh(surfacePoints()); }

SurfaceTracker::Compact Simulation::surface() const {
  return organ_.surface.compact(surfacePoints(), surfaceNormals());
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
  const TriangleMesh surface = organ_.surface.mesh();
  hash.addSpan(std::span<const Vec3>(surface.points));
  hash.addSpan(std::span<const Triangle>(surface.triangles));
  for (const ToolState& state : tools_) {
    hash.addBytes(state.pose.position.data(), 3 * sizeof(double));
    hash.addBytes(state.pose.rotation.coeffs().data(), 4 * sizeof(double));
    hash.add(std::uint8_t(state.inHand));
    if (state.tool->model().jaws.opening > 0) hash.add(state.squeeze);
  }
  if (tissue_->moves()) {
    hash.add(tissue_->stateHash());
    hash.addSpan(skin_.points());
  }
  return hash.value();
}

}  // namespace resect
