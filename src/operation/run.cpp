#include "operation/run.h"

#include <algorithm>

#include "base/stop.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "organ/pieces.h"

namespace resect {

SurfaceSummary summarise(const TriangleMesh& surface) {
  const Topology t = topology(surface);
  return {std::int64_t(surface.triangles.size()), t.closed(), t.oriented(), volume(surface)};
}

std::vector<LabelSummary> summariseLabels(const Organ& organ, const TissueSetup& tissue) {
  const Discretization& rest = organ.rest;
  std::vector<LabelSummary> all(256);
  for (std::int64_t cell = 0; cell < rest.lattice.cellCount(); ++cell) {
    const bool particle = rest.inside[std::size_t(cell)];
    // Skin cells count with their particle; those without one count by themselves.
    if (!particle && !(rest.value[std::size_t(cell)] > 0 && ownerCell(rest, cell) == cell))
      continue;
    LabelSummary& label = all[rest.labelOf(cell)];
    const double volume = particleVolume(rest, cell);
    label.before.particles += particle;
    label.before.volume += volume;
    LabelSummary::Amount& now = organ.alive[std::size_t(cell)] ? label.remaining : label.removed;
    now.particles += particle;
    now.volume += volume;
  }
  std::vector<LabelSummary> labels;
  for (int i = 0; i < int(all.size()); ++i) {
    LabelSummary& one = all[std::size_t(i)];
    if (one.before.particles == 0) continue;
    one.label = i;
    one.name = rest.labelName(i);
    const double density = tissue.materialOf(i).density;
    for (LabelSummary::Amount* amount : {&one.before, &one.removed, &one.remaining})
      amount->mass = amount->volume * density;
    labels.push_back(std::move(one));
  }
  return labels;
}

namespace {

double massOf(const Body& body, const TissueSetup& tissue) {
  double mass = 0;
  for (std::size_t label = 0; label < body.tissueOf.size(); ++label)
    mass += body.tissueOf[label] * tissue.materialOf(int(label)).density;
  return mass;
}

}  // namespace

RunSummary runScenario(Simulation& simulation, const Scenario& scenario,
                       const FrameObserver& observer) {
  RunSummary summary;
  for (const OperatedOrgan& o : simulation.organs()) {
    summary.particles += o.organ.particles;
    summary.organVolume += o.organ.volume();
  }
  summary.surfaceBefore = summarise(simulation.surfaceMesh());

  summary.tissueMoves = simulation.moves();
  if (summary.tissueMoves)
    for (const ToolState& state : simulation.tools())
      summary.forces.push_back({state.tool->model.name, 0, {}});

  StageClock clock;
  StepReport report;
  const std::int64_t frames = frameCount(scenario);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    const FrameInput input = frameInput(scenario, frame);
    simulation.step(input, report, &clock);
    ++summary.frames;
    for (const ToolContacts& contacts : report.contacts)
      summary.deepestOverlap = std::max(summary.deepestOverlap, contacts.overlapVolume),
      summary.touched = summary.touched || !contacts.cells.empty();
    summary.simulatedSeconds = report.time;
    for (const std::string& fault : report.faults)
      if (std::find(summary.faults.begin(), summary.faults.end(), fault) == summary.faults.end())
        summary.faults.push_back(fault);
    for (std::size_t i = 0; i < summary.forces.size(); ++i) {
      const double force = report.toolForce[i].norm();
      summary.forces[i].peak = std::max(summary.forces[i].peak, force);
      summary.touched = summary.touched || force > 0;
      summary.forces[i].perFrame.push_back(float(force));
    }
    summary.severed += report.severed;
    summary.torn += report.torn;
    for (const TissueStep& step : report.tissue) {
      summary.substeps += step.substeps;
      summary.retries += step.retries;
    }
    if (observer && !observer(simulation, input, report)) break;
    checkStop();
  }

  for (const OperatedOrgan& o : simulation.organs()) {
    summary.removed += o.organ.removed;
    summary.removedVolume += o.organ.removedVolume;
    summary.remainingVolume += o.organ.volume();
  }
  summary.stages = clock.stages();
  for (const StageTimes& stage : summary.stages)
    summary.computedSeconds += summarise(stage.seconds).total;
  summary.surface = summarise(simulation.surfaceMesh());
  for (std::size_t i = 0; i < simulation.organs().size(); ++i) {
    const OperatedOrgan& o = simulation.organs()[i];
    const TissueSetup& tissue = scenario.organs[i].tissue;
    checkStop();
    for (const Body& body : bodies(o.organ, o.organ.surface.mesh(o.points())))
      summary.pieces.push_back(
          {summarise(body.mesh), body.particles, body.tissue, massOf(body, tissue), o.name});
    for (LabelSummary& label : summariseLabels(o.organ, tissue)) {
      label.organ = o.name;
      summary.labels.push_back(std::move(label));
    }
  }
  summary.stateHash = simulation.stateHash();
  return summary;
}

}  // namespace resect
