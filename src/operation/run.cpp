#include "operation/run.h"

#include <algorithm>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "organ/pieces.h"

namespace resect {

SurfaceSummary summarise(const TriangleMesh& surface) {
  const Topology t = topology(surface);
  return {std::int64_t(surface.triangles.size()), t.closed(), t.oriented(), volume(surface)};
}

RunSummary runScenario(Simulation& simulation, const Scenario& scenario,
                       const FrameObserver& observer) {
  RunSummary summary;
  const Organ& organ = simulation.organ();
  summary.particles = organ.particles;
  summary.organVolume = organ.volume();
  summary.surfaceBefore = summarise(organ.surface.mesh());

  StageClock clock;
  StepReport report;
  const std::int64_t frames = frameCount(scenario);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    simulation.step(frameInput(scenario, frame), report, &clock);
    ++summary.frames;
    for (const ToolContacts& contacts : report.contacts)
      summary.deepestOverlap = std::max(summary.deepestOverlap, contacts.overlapVolume);
    summary.simulatedSeconds = report.time;
    for (const std::string& fault : report.faults)
      if (std::find(summary.faults.begin(), summary.faults.end(), fault) == summary.faults.end())
        summary.faults.push_back(fault);
    if (observer && !observer(simulation, report)) break;
  }

  summary.removed = organ.removed;
  summary.removedVolume = organ.removedVolume;
  summary.remainingVolume = organ.volume();
  summary.stages = clock.stages();
  for (const StageTimes& stage : summary.stages)
    summary.computedSeconds += summarise(stage.seconds).total;
  const TriangleMesh surface = organ.surface.mesh();
  summary.surface = summarise(surface);
  for (const TriangleMesh& piece : bodies(organ)) summary.pieces.push_back(summarise(piece));
  summary.stateHash = simulation.stateHash();
  return summary;
}

}  // namespace resect
