// Runs a scenario frame by frame and summarises it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "operation/blood/blood_summary.h"
#include "operation/ledger/ledger.h"
#include "operation/ledger/segment_amounts.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

struct SurfaceSummary {
  std::int64_t triangles = 0;
  bool closed = false, oriented = false;
  double volume = 0;  // enclosed by the surface, m^3
  Aabb box;           // m; empty without triangles
};
SurfaceSummary summarise(const TriangleMesh& surface);

// The forces on a tool, N.
struct ToolForces {
  std::string tool;
  double peak = 0;              // the largest of perFrame
  std::vector<float> perFrame;  // magnitude of each frame's mean force
};

struct RunSummary {
  Ledger ledger;  // at the end of the run
  // Largest volume in which a tool overlapped tissue that does not move, at the end of a frame,
  // m^3.
  double deepestOverlap = 0;
  // touched: whether any tool touched tissue. toolTouched: for each tool, whether it worked on
  // tissue or took blood away. If tissue moves, a tool that only came near tissue counts too,
  // since an electrosurgical pencil or a clamp acts from beside the tissue.
  bool touched = false;
  std::vector<bool> toolTouched;
  std::int64_t frames = 0;
  double simulatedSeconds = 0;
  double computedSeconds = 0;  // time spent in the steps, without pictures
  // The surface of all organs, before the operation and at the end. The volume inside this surface
  // differs a little from the volume in the ledger, which is the volume of the tissue in cells.
  SurfaceSummary surfaceBefore, surface;
  std::vector<StageTimes> stages;
  std::vector<std::string> faults;         // each sentence once
  bool tissueMoves = false;                // whether any tissue is elastic
  std::vector<ToolForces> forces;          // one per tool; empty if no tissue moves
  std::int64_t severed = 0, torn = 0;      // bonds severed by edits; bonds torn by load
  std::int64_t substeps = 0, retries = 0;  // sums over all frames and organs
  std::optional<BloodSummary> blood;       // set if any organ has vessels
  std::vector<SegmentAmount> segments;     // of the first organ that has Couinaud's segments
  std::uint64_t stateHash = 0;

  // Simulated time divided by the time spent in the steps.
  double realTimeFactor() const {
    return computedSeconds > 0 ? simulatedSeconds / computedSeconds : 0;
  }
};

// Called after each frame. If it returns false, the operation ends with this frame.
using FrameObserver = std::function<bool(const Simulation&, const FrameInput&, const StepReport&)>;

// Runs all frames of the scenario. simulation: made by the caller from this scenario (see
// io/operation_setup.h; the layer `operation` reads no files).
RunSummary runScenario(Simulation& simulation, const Scenario& scenario,
                       const FrameObserver& observer = {});

}  // namespace resect
