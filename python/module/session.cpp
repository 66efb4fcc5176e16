#include "session.h"

#include <algorithm>

#include "base/error.h"
#include "inventor/reading/model_file.h"
#include "io/operation_setup.h"
#include "operation/way/place_ways.h"
#include "organ/cell_labels.h"
#include "organ/region_placer.h"

namespace resect::python {

Session::Session(Scenario wanted, std::optional<Discretization> cells)
    : scenario(std::move(wanted)) {
  makeSimulation(std::move(cells));
  kept_.resize(simulation->organs().size());
}

Session::Session(const RecordedSetup& setup)
    : scenario(setup.scenario), simulation(std::make_unique<Simulation>(simulationOf(setup))) {
  kept_.resize(simulation->organs().size());
}

Session::~Session() = default;

void Session::makeSimulation(std::optional<Discretization> cells) {
  if (!cells) {
    simulation =
        std::make_unique<Simulation>(resect::makeSimulation(scenario, readModel, {}, &notes));
    return;
  }
  require(scenario.organs.size() == 1,
          "the scenario \"{}\" has {} organs; an organ of your own takes the place of a single one",
          scenario.name, scenario.organs.size());
  ScenarioOrgan& first = scenario.organs[0];
  first.source.vessels.clear();
  RegionPlacer place(*cells);
  for (const OrganLabel& one : first.source.labels) {
    if (markCells(*cells, one.label, place(one.region)) == 0)
      throw error("label {} ({}) marks no particle of the organ; move or enlarge its region",
                  one.label, one.name);
    if (!one.name.empty()) cells->nameLabel(one.label, one.name);
  }
  if (!first.source.labels.empty()) labelSkin(*cells);
  Organ organ = makeOrgan(std::move(*cells), first.source.settings);
  if (hasWays(scenario))
    placeWays(scenario, 0,
              {organ.surface.mesh(), organ.rest.landmarks, organ.rest.lattice.spacing});
  auto tissue = makeTissue(first.tissue, organ);
  std::vector<OperatedOrgan> organs;
  organs.push_back(operatedOrgan(first.source.name, std::move(organ), std::move(tissue)));
  simulation = std::make_unique<Simulation>(
      assemble(scenario, std::move(organs), {}, loadTools(scenario, readModel)));
  settleWays(scenario, *simulation);
}

std::unique_lock<std::mutex> Session::mine() {
  std::unique_lock<std::mutex> lock(busy_, std::try_to_lock);
  if (!lock)
    throw usageError(
        "this simulation is stepping in another thread; give each thread a simulation of its own");
  return lock;
}

void Session::step(const FrameInput& input, StepReport& report) {
  const auto lock = mine();
  simulation->step(input, report);
  ++changes_;
  if (!recorder_) return;
  recorder_->record(input, report, *simulation);
}

Bytes Session::save() {
  const auto lock = mine();
  return simulation->save();
}

void Session::restore(std::span<const std::byte> state) {
  const auto lock = mine();
  if (recorder_)
    throw usageError(
        "a recording follows one line of time; call end_recording() before you restore a state");
  ++changes_;
  simulation->restore(state);
}

std::uint64_t Session::stateHash() {
  const auto lock = mine();
  return simulation->stateHash();
}

Ledger Session::ledger() {
  const auto lock = mine();
  if (!books_) books_.emplace(scenario, *simulation);
  return books_->ledgerOf(*simulation);
}

void Session::record(const std::string& path) {
  const auto lock = mine();
  if (recorder_)
    throw usageError("a recording is at work, {}; call end_recording() before the next",
                     recorder_->path().string());
  if (simulation->frame() != 0)
    throw usageError(
        "a recording begins at frame 0, and {} frames are done; call record() before the first "
        "step",
        simulation->frame());
  recorder_.emplace(path, scenario, *simulation);
}

void Session::endRecording() {
  const auto lock = mine();
  if (!recorder_) throw usageError("no recording is at work; begin one by record()");
  recorder_->stood({0, simulation->frame()}, *simulation);
  recorder_->finish();
  const std::string failure = recorder_->failure();
  recorder_.reset();
  if (!failure.empty()) throw error("{}", failure);
}

std::vector<ToolInput> Session::presentInputs() const {
  std::vector<ToolInput> inputs;
  for (const ToolState& state : simulation->tools())
    inputs.push_back({state.pose(), state.inHand, state.way.to.squeeze, state.way.to.pedal});
  return inputs;
}

void Session::requireOrgan(std::size_t organ) const {
  require(organ < simulation->organs().size(), "there is no organ {} among {}; number from 0",
          organ, simulation->organs().size());
}

Session::Points Session::points(std::size_t organ) {
  requireOrgan(organ);
  const auto lock = mine();
  Kept& kept = kept_[organ];
  if (kept.points && kept.change == changes_) return kept.points;
  const std::span<const Vec3f> now = simulation->organs()[organ].points();
  // Memory that no array uses any more is used again.
  if (!kept.points || kept.points.use_count() > 1)
    kept.points = std::make_shared<std::vector<Vec3f>>();
  kept.points->assign(now.begin(), now.end());
  kept.change = changes_;
  return kept.points;
}

}  // namespace resect::python
