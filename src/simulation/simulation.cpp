#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "tools/contacts.h"

namespace resect {

namespace {

std::vector<OperatedOrgan> one(Organ organ, std::unique_ptr<TissueModel> tissue) {
  std::vector<OperatedOrgan> organs;
  organs.push_back(operatedOrgan("organ", std::move(organ), std::move(tissue)));
  return organs;
}

constexpr double kLongestCarving = 1, kWidestCarving = 0.1;  // m, by one edit

double shareOf(double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0; }

}  // namespace

Simulation::Simulation(std::vector<OperatedOrgan> organs, std::vector<std::unique_ptr<Tool>> tools,
                       std::vector<TissueJoint> joints, bool table)
    : organs_(std::move(organs)), joints_(std::move(joints)), table_(table) {
  require(!organs_.empty(), "there is nothing to operate on; give at least one organ");
  for (const OperatedOrgan& o : organs_)
    require(o.tissue != nullptr, "organ \"{}\" has no tissue; make it by operatedOrgan()", o.name);
  for (const TissueJoint& joint : joints_) requireSound(joint);
  for (auto& tool : tools) {
    require(tool != nullptr, "tool {} is null; give what makeTool() returns", tools_.size());
    tools_.emplace_back();
    tools_.back().tool = std::move(tool);
  }
  blood_ = Bleeding(organs_);
  work_.removedCells.resize(organs_.size());
  work_.touchedBricks.resize(organs_.size());
  work_.obstacles.resize(organs_.size());
  work_.edges.resize(tools_.size());
  if (!moves()) return;
  double finest = organs_[0].organ.rest.lattice.spacing.x(), coarsest = finest;
  for (const OperatedOrgan& o : organs_) {
    finest = std::min(finest, o.organ.rest.lattice.spacing.x());
    coarsest = std::max(coarsest, o.organ.rest.lattice.spacing.x());
  }
  for (const ToolState& state : tools_)
    shapes_.push_back(std::make_unique<SignedDistance>(state.tool->model.mesh, 2 * coarsest,
                                                       std::clamp(finest / 6, 0.0005, 0.002)));
  for (const TissueJoint& joint : joints_)
    for (int end = 0; end < 2; ++end)
      organs_[std::size_t(joint.organ[end])].tissue->mayPull(joint.cell[end]);
  for (OperatedOrgan& o : organs_) {
    if (!o.tissue->moves()) continue;
    o.tissue->settle();
    o.skin.follow(o.organ.surface, o.organ.rest.lattice, *o.tissue, {}, keepsLook_);
  }
}

Simulation::Simulation(Organ organ, std::vector<std::unique_ptr<Tool>> tools,
                       std::unique_ptr<TissueModel> tissue, bool table)
    : Simulation(one(std::move(organ), std::move(tissue)), std::move(tools), {}, table) {}

StepReport Simulation::step(const FrameInput& input, StageClock* clock) {
  StepReport report;
  step(input, report, clock);
  return report;
}

void Simulation::step(const FrameInput& input, StepReport& report, StageClock* clock) {
  const auto done = [&](const char* stage) {
    if (clock) clock->lap(stage);
  };
  requireSound(input);
  if (clock) clock->start();
  halfDone_ = true;

  moveTools(input, report);
  done("moveTools");
  findContacts();
  done("findContacts");
  actTools(input);
  done("actTools");
  applyEdits(report);
  done("applyEdits");
  moveTissue(input, report);
  done("moveTissue");
  applyCuts(report);
  done("applyCuts");
  updateField(report);
  done("updateField");
  updateSurface(input);
  done("updateSurface");
  heatTissue(input, report);
  done("heatTissue");
  flowBlood(input, report);
  done("flowBlood");
  measure(input, report);
  done("measure");
  halfDone_ = false;
}

void Simulation::requireSound(const FrameInput& input) const {
  require(input.tools.size() == tools_.size(),
          "the frame has input for {} tools, the operation has {}; give one for each",
          input.tools.size(), tools_.size());
  require(input.duration >= 0 && input.duration <= kLongestFrame,
          "the frame lasts {} s; give 0 to {} s", input.duration, kLongestFrame);
  for (const TissueEdit& edit : input.edits) {
    require(edit.organ >= 0 && std::size_t(edit.organ) < organs_.size(),
            "an edit is for organ {}, and there are {}; number from 0", edit.organ, organs_.size());
    require(edit.tool >= -1 && edit.tool < std::int32_t(tools_.size()),
            "an edit is by tool {}, and there are {}; give -1 for nobody, or number from 0",
            edit.tool, tools_.size());
    const std::int64_t cells = organs_[std::size_t(edit.organ)].organ.rest.lattice.cellCount();
    std::visit(
        [&](const auto& what) {
          if constexpr (requires { what.cell; })
            require(what.cell >= 0 && what.cell < cells, "an edit is of cell {}; give 0 to {}",
                    what.cell, cells - 1);
        },
        edit.what);
    if (const auto* carving = std::get_if<Carve>(&edit.what)) {
      const CarvedLine& line = carving->line;
      require(line.from.allFinite() && line.to.allFinite() && line.radius >= 0 &&
                  line.radius <= kWidestCarving && (line.to - line.from).norm() <= kLongestCarving,
              "an edit carves {} m long with a radius of {} m; give at most {} and {} m",
              (line.to - line.from).norm(), line.radius, kLongestCarving, kWidestCarving);
    }
    const auto* grip = std::get_if<Grip>(&edit.what);
    require(!grip || isFinite(grip->pose),
            "tool {} grips in a pose that is not a number; give a finite one", edit.tool);
  }
}

void Simulation::requireSound(const TissueJoint& joint) const {
  for (int end = 0; end < 2; ++end) {
    const std::int32_t organ = joint.organ[std::size_t(end)];
    require(organ >= 0 && std::size_t(organ) < organs_.size(),
            "a joint is at organ {}, and there are {}; number from 0", organ, organs_.size());
    const std::int64_t cell = joint.cell[std::size_t(end)],
                       cells = organs_[std::size_t(organ)].organ.rest.lattice.cellCount();
    require(cell >= 0 && cell < cells,
            "a joint is at cell {} of organ {}, which has {}; number from 0", cell, organ, cells);
  }
  require(joint.rest.allFinite() && joint.stiffness >= 0 && joint.damping >= 0 &&
              std::isfinite(joint.stiffness) && std::isfinite(joint.damping),
          "a joint has stiffness {} N/m and damping {} N s/m; give finite numbers from 0",
          joint.stiffness, joint.damping);
}

// Sets the tools' new poses. A tool just taken in hand starts at its pose, without a sweep.
void Simulation::moveTools(const FrameInput& input, StepReport& report) {
  report.faults.clear();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    ToolState& state = tools_[i];
    const ToolInput& wanted = input.tools[i];
    if (!isFinite(wanted.pose)) {
      report.faults.push_back(fmt::format(
          "the pose of tool \"{}\" is not a number; it stays where it was: check the tool's motion",
          state.tool->model.name));
      // The motion of the frame before is cleared too.
      state.wasInHand = state.inHand;
      state.way = {state.way.to, state.way.to};
      continue;
    }
    const ToolStance now{wanted.pose, shareOf(wanted.squeeze), shareOf(wanted.pedal)};
    state.wasInHand = state.inHand;
    state.inHand = wanted.inHand;
    state.way = state.wasInHand ? ToolWay{state.way.to, now} : ToolWay{now, now};
  }
}

// Finds the particles that each tool in hand sweeps over.
void Simulation::findContacts() {
  work_.contacts.resize(tools_.size() * organs_.size());
  auto contacts = work_.contacts.begin();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolState& state = tools_[i];
    for (std::size_t o = 0; o < organs_.size(); ++o, ++contacts) {
      *contacts = state.inHand
                      ? resect::findContacts(organs_[o].organ, *organs_[o].tissue, *state.tool,
                                             state.way.from.pose, state.way.to.pose)
                      : ToolContacts{};
      contacts->tool = std::int32_t(i);
      contacts->organ = std::int32_t(o);
    }
  }
}

// Each working part queues edits; nothing changes yet.
void Simulation::actTools(const FrameInput& input) {
  work_.edits.assign(input.edits.begin(), input.edits.end());
  for (const ToolContacts& contacts : work_.contacts) {
    const ToolState& state = tools_[std::size_t(contacts.tool)];
    const OperatedOrgan& organ = organs_[std::size_t(contacts.organ)];
    if (!state.inHand) continue;
    const Touch touch{state.tool->model, state.way,      input.duration,
                      contacts.tool,     contacts.organ, organ.organ,
                      *organ.tissue,     contacts,       state.feltForce.norm()};
    for (const auto& part : state.tool->parts) part->act(touch, work_.edits);
  }
  for (std::size_t i = 0; i < tools_.size(); ++i)
    if (!tools_[i].inHand && tools_[i].wasInHand)
      for (std::size_t o = 0; o < organs_.size(); ++o)
        work_.edits.push_back({std::int32_t(o), std::int32_t(i), Release{}});
}

EditSummary Simulation::apply(std::span<const TissueEdit> edits, StepReport& report) {
  EditSummary sum;
  for (std::size_t o = 0; o < organs_.size(); ++o) {
    const EditSummary summary =
        resect::applyEdits(organs_[o], std::int32_t(o), edits, work_.removedCells[o]);
    sum.removed += summary.removed;
    sum.removedVolume += summary.removedVolume;
    sum.severed += summary.severed;
    sum.incised += summary.incised;
    for (const std::int32_t segment : summary.vessels)
      report.vessels.push_back({std::int32_t(o), segment});
    for (const VesselClip& clip : summary.slipped)
      report.slipped.push_back({std::int32_t(o), clip.segment});
  }
  return sum;
}

void Simulation::applyEdits(StepReport& report) {
  for (auto& removed : work_.removedCells) removed.clear();
  report.vessels.clear(), report.slipped.clear();
  const EditSummary summary = apply(work_.edits, report);
  report.removed = summary.removed;
  report.removedVolume = summary.removedVolume;
  report.severed = summary.severed + summary.incised;
  dropJoints();
}

void Simulation::applyCuts(StepReport& report) {
  const EditSummary summary = apply(work_.caused, report);
  report.severed += summary.incised;
  report.torn = summary.severed;
}

// Evaluates the bricks of the colour field in reach of the edits.
void Simulation::updateField(StepReport& report) {
  report.touchedBricks = 0;
  for (std::size_t o = 0; o < organs_.size(); ++o) {
    work_.touchedBricks[o] = resect::updateField(organs_[o].organ);
    report.touchedBricks += std::int64_t(work_.touchedBricks[o].size());
  }
}

// Meshes the same bricks; all bricks if the iso level changed.
void Simulation::updateSurface(const FrameInput& input) {
  for (std::size_t i = 0; i < organs_.size(); ++i) {
    OperatedOrgan& o = organs_[i];
    if (input.iso && *input.iso >= kMinIso && *input.iso <= kMaxIso && *input.iso != o.organ.iso)
      setIso(o.organ, *input.iso);
    else
      resect::updateSurface(o.organ, work_.touchedBricks[i]);
    if (keepsLook_) o.organ.surface.updateLook(o.organ.field);
    if (o.tissue->moves())
      o.skin.follow(o.organ.surface, o.organ.rest.lattice, *o.tissue, work_.removedCells[i],
                    keepsLook_);
  }
}

// Updates time and frame, and reports faults.
void Simulation::measure(const FrameInput& input, StepReport& report) {
  if (input.iso && !(*input.iso >= kMinIso && *input.iso <= kMaxIso))
    report.faults.push_back(
        fmt::format("iso level {} is outside {} to {}; the level stays as it was", *input.iso,
                    kMinIso, kMaxIso));
  report.contacts.swap(work_.contacts);
  report.edits.swap(work_.edits);
  report.caused.swap(work_.caused);
  time_ += input.duration;
  report.frame = frame_++;
  report.time = time_;
}

bool Simulation::moves() const {
  return std::ranges::any_of(organs_, [](const OperatedOrgan& o) { return o.tissue->moves(); });
}

void Simulation::dropJoints() {
  if (joints_.empty()) return;
  std::erase_if(joints_, [&](const TissueJoint& joint) {
    const auto gone = [&](int end) {
      return !organs_[std::size_t(joint.organ[end])].tissue->solid(joint.cell[end]);
    };
    return gone(0) || gone(1);
  });
}

void Simulation::findJoined() {
  joined_.clear();
  for (std::size_t o = 0; o < organs_.size() && !joints_.empty(); ++o)
    joined_.push_back({std::int32_t(o), &organs_[o].organ.rest.lattice, organs_[o].tissue.get()});
}

void Simulation::keepLook() {
  keepsLook_ = true;
  for (OperatedOrgan& o : organs_) {
    o.organ.surface.updateLook(o.organ.field);
    if (o.tissue->moves()) o.skin.turnNormals(o.organ.surface);
  }
}

TriangleMesh Simulation::surfaceMesh() const {
  TriangleMesh mesh;
  for (const OperatedOrgan& o : organs_) append(mesh, o.organ.surface.mesh(o.points()));
  return mesh;
}

SurfaceTracker::Compact Simulation::surface() const {
  require(keepsLook_, "this simulation does not keep its look; call keepLook() before");
  SurfaceTracker::Compact all;
  for (const OperatedOrgan& o : organs_) {
    const SurfaceTracker::Compact part = o.organ.surface.compact(o.points(), o.normals());
    append(all.mesh, part.mesh);
    all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
    all.cut.insert(all.cut.end(), part.cut.begin(), part.cut.end());
  }
  return all;
}

std::size_t Simulation::bytes() const {
  std::size_t sum = 0;
  for (const OperatedOrgan& o : organs_) sum += o.bytes();
  return sum + blood_.bytes();
}

}  // namespace resect
