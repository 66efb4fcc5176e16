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

// One of the bodies into which an organ was divided.
struct PieceSummary {
  SurfaceSummary surface;
  std::int64_t particles = 0;
  double tissue = 0;  // m^3
  double mass = 0;    // kg
  std::string organ;  // organ that it belongs to
};

// Totals for the cells of a label.
struct LabelSummary {
  struct Amount {
    std::int64_t particles = 0;
    double volume = 0;  // m^3, skin cells included
    double mass = 0;    // kg, with the density of the label's material
  };
  int label = 0;
  std::string name;
  Amount before, removed, remaining;
  std::string organ;
};
// One summary for each label that particles had before the operation, ascending by label.
std::vector<LabelSummary> summariseLabels(const Organ& organ, const TissueSetup& tissue);

// The force on a tool over the frames, N.
struct ToolForces {
  std::string tool;
  double peak = 0;              // largest of perFrame
  std::vector<float> perFrame;  // magnitude of each frame's mean force
};

struct RunSummary {
  std::int64_t particles = 0;  // before the operation
  double organVolume = 0;      // m^3 before the operation: tissue in all cells
  std::int64_t removed = 0;    // particles
  double removedVolume = 0;    // m^3
  double remainingVolume = 0;  // m^3 of tissue left in all cells
  double deepestOverlap = 0;   // m^3: largest overlap of a tool and an organ at a frame's end
  bool touched = false;        // whether any instrument touched an organ
  std::int64_t frames = 0;
  double simulatedSeconds = 0;
  double computedSeconds = 0;  // spent in the steps, pictures not counted
  SurfaceSummary surfaceBefore, surface;
  std::vector<PieceSummary> pieces;  // bodies at the end, organ by organ, the largest first
  std::vector<LabelSummary> labels;  // organ by organ, labels ascending; label 0 is parenchyma
  std::vector<StageTimes> stages;
  std::vector<std::string> faults;  // each once
  bool tissueMoves = false;
  std::vector<ToolForces> forces;      // one per tool, when the tissue moves
  std::int64_t severed = 0, torn = 0;  // bonds
  std::int64_t substeps = 0, retries = 0;
  std::uint64_t stateHash = 0;

  double realTimeFactor() const {
    return computedSeconds > 0 ? simulatedSeconds / computedSeconds : 0;
  }
};

// Called after each frame; returns false to stop the operation there.
using FrameObserver = std::function<bool(const Simulation&, const StepReport&)>;

// Runs all frames of the scenario on a simulation made for it (operation does not read files).
RunSummary runScenario(Simulation& simulation, const Scenario& scenario,
                       const FrameObserver& observer = {});

}  // namespace resect
