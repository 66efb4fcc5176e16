// Runs a scenario frame by frame and summarises it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

struct SurfaceSummary {
  std::int64_t triangles = 0;
  bool closed = false, oriented = false;
  double volume = 0;  // m^3
};
SurfaceSummary summarise(const TriangleMesh& surface);

// One of the bodies into which the organs were divided.
struct PieceSummary {
  SurfaceSummary surface;
  std::int64_t particles = 0;
  double tissue = 0;  // of its particles with their skin cells, m^3
  double mass = 0;    // kg
  std::string organ;  // name of the organ that it belongs to
};

// Totals over the cells with one label.
struct LabelSummary {
  struct Amount {
    std::int64_t particles = 0;
    double volume = 0;  // m^3, skin cells included
    double mass = 0;    // kg, at the density of the label's material
  };
  int label = 0;
  std::string name;
  Amount before, removed, remaining;
  std::string organ;  // name of the organ
};
// One summary for each label that particles had before the operation, ascending by label. Leaves
// LabelSummary::organ empty.
std::vector<LabelSummary> summariseLabels(const Organ& organ, const TissueSetup& tissue);

// The force on a tool in each frame, N.
struct ToolForces {
  std::string tool;
  double peak = 0;              // the largest of perFrame
  std::vector<float> perFrame;  // magnitude of the mean force in the frame
};

struct RunSummary {
  std::int64_t particles = 0;  // before the operation
  double organVolume = 0;      // of tissue in all cells before the operation, m^3
  std::int64_t removed = 0;    // particles removed
  double removedVolume = 0;    // of tissue, m^3
  double remainingVolume = 0;  // of tissue left in all cells, m^3
  // Largest overlap of a tool and still tissue at the end of a frame, m^3.
  double deepestOverlap = 0;
  bool touched = false;  // whether any instrument touched tissue
  std::int64_t frames = 0;
  double simulatedSeconds = 0;
  double computedSeconds = 0;             // time spent in the steps, without pictures
  SurfaceSummary surfaceBefore, surface;  // of all organs: before the operation; at the end
  std::vector<PieceSummary> pieces;  // bodies at the end: organ by organ, the largest first in each
  std::vector<LabelSummary> labels;  // organ by organ, labels ascending in each
  std::vector<StageTimes> stages;
  std::vector<std::string> faults;         // each sentence once
  bool tissueMoves = false;                // whether any tissue is elastic
  std::vector<ToolForces> forces;          // one per tool; none if no tissue moves
  std::int64_t severed = 0, torn = 0;      // bonds that edits severed; bonds that tore
  std::int64_t substeps = 0, retries = 0;  // sums over all frames and organs
  std::uint64_t stateHash = 0;

  // Simulated time over the time that it took to compute.
  double realTimeFactor() const {
    return computedSeconds > 0 ? simulatedSeconds / computedSeconds : 0;
  }
};

// Called after each frame. If it returns false, the operation ends with this frame.
using FrameObserver = std::function<bool(const Simulation&, const FrameInput&, const StepReport&)>;

// Runs all frames of the scenario. `simulation` must have been made from this scenario by the
// caller, since the layer `operation` reads no files.
RunSummary runScenario(Simulation& simulation, const Scenario& scenario,
                       const FrameObserver& observer = {});

}  // namespace resect
