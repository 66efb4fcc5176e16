#include "operation/run.h"

#include <algorithm>
#include <variant>

#include "base/stop.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "operation/live/operation_events.h"

namespace resect {
namespace {

Picolitres takenBy(const StepReport& report) {
  return report.blood.ledger.sucked + report.blood.ledger.absorbed;
}

// Whether the tool is suction or gauze at work in this step, and blood was taken away. before: what
// had been taken before the step.
bool takesBlood(const StepReport& report, Picolitres before, std::size_t tool) {
  return takenBy(report) > before && std::ranges::any_of(report.edits, [&](const TissueEdit& edit) {
           return edit.tool == std::int32_t(tool) && (std::holds_alternative<Suction>(edit.what) ||
                                                      std::holds_alternative<Press>(edit.what));
         });
}

}  // namespace

SurfaceSummary summarise(const TriangleMesh& surface) {
  const Topology t = topology(surface);
  return {std::int64_t(surface.triangles.size()), t.closed(), t.oriented(), volume(surface),
          bounds(surface)};
}

RunSummary runScenario(Simulation& simulation, const Scenario& scenario,
                       const FrameObserver& observer) {
  RunSummary summary;
  summary.surfaceBefore = summarise(simulation.surfaceMesh());

  summary.toolTouched.resize(simulation.tools().size());
  summary.tissueMoves = simulation.moves();
  if (summary.tissueMoves)
    for (const ToolState& state : simulation.tools())
      summary.forces.push_back({state.tool->model.name, 0, {}});

  StageClock clock;
  StepReport report;
  BloodBooks blood;
  Picolitres taken = 0;
  const std::int64_t frames = frameCount(scenario);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    const FrameInput input = frameInput(scenario, frame);
    simulation.step(input, report, &clock);
    ++summary.frames;
    for (const ToolContacts& contacts : report.contacts) {
      summary.deepestOverlap = std::max(summary.deepestOverlap, contacts.overlapVolume);
      const bool inside = !contacts.cells.empty();
      summary.touched = summary.touched || inside;
      // A pencil or a clamp acts from beside the tissue.
      if (inside || (summary.tissueMoves && !contacts.volumeOfInterest.empty()))
        summary.toolTouched[std::size_t(contacts.tool)] = true;
    }
    summary.simulatedSeconds = report.time;
    for (const std::string& fault : report.faults)
      if (std::find(summary.faults.begin(), summary.faults.end(), fault) == summary.faults.end())
        summary.faults.push_back(fault);
    for (std::size_t i = 0; i < summary.forces.size(); ++i) {
      if (worksOnOrgan(report, simulation, i) || takesBlood(report, taken, i))
        summary.toolTouched[i] = true;
      const double force = report.toolForce[i].norm();
      summary.forces[i].peak = std::max(summary.forces[i].peak, force);
      summary.touched = summary.touched || force > 0;
      summary.forces[i].perFrame.push_back(float(force));
    }
    blood.add(report, input.duration);
    taken = takenBy(report);
    summary.severed += report.severed;
    summary.torn += report.torn;
    summary.touched = summary.touched || report.removed > 0 || report.severed > 0;
    for (const TissueStep& step : report.tissue) {
      summary.substeps += step.substeps;
      summary.retries += step.retries;
    }
    if (observer && !observer(simulation, input, report)) break;
    checkStop();
  }

  summary.stages = clock.stages();
  for (const StageTimes& stage : summary.stages)
    summary.computedSeconds += summarise(stage.seconds).total;
  summary.surface = summarise(simulation.surfaceMesh());
  checkStop();
  summary.ledger = LedgerBooks(scenario, simulation).ledgerOf(simulation);
  summary.blood = blood.summaryOf(simulation);
  for (const OperatedOrgan& organ : simulation.organs())
    if (summary.segments.empty()) summary.segments = segmentAmounts(organ);
  summary.stateHash = simulation.stateHash();
  return summary;
}

}  // namespace resect
