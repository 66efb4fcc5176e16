// The state of an operation that the window shows in its panels: counts, volumes, forces, times.
// The surface is not part of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "operation/live/step_times.h"
#include "operation/live/tip_place.h"
#include "simulation/simulation.h"

namespace resect {

// The state after the newest frame.
struct LiveState {
  std::int64_t frame = 0;
  double time = 0;         // simulated, s
  double lastRemoval = 0;  // steady clock at the last removal of particles, s; 0: none
  // Particles left; particles removed so far; triangles of the surface.
  std::int64_t particles = 0, removed = 0, triangles = 0;
  double removedVolume = 0, volume = 0;  // of the tissue removed; of the tissue left; m^3
  float iso = 50;                        // iso level
  bool moves = false;                    // whether any tissue is elastic
  std::vector<std::string> faults;       // since the last LiveOperation::take(), each once
  std::vector<ToolInput> played;   // the tools' inputs while a motion plays; empty: no motion plays
  int undoable = 0, redoable = 0;  // strokes that can be taken back; that can be done again
  // Number of calls of undo() and redo() that were done, and the tools as the last one left them.
  std::int64_t jumps = 0;
  std::vector<ToolInput> jumpedTools;
  StepTimes times;
  // The lists below have one element per tool.
  std::vector<TipPlace> tips;      // valid only while the tool is in hand
  std::vector<double> squeeze;     // of its jaws: 0 wide open, 1 closed
  std::vector<double> forces;      // smoothed force of the tissue on the tool, N
  std::vector<double> peakForces;  // largest force in any frame so far, as that frame's mean, N
  std::vector<double> lastTouch;   // simulated time when the tool last touched tissue, s; -1: never
  std::vector<std::uint8_t> touching;  // 1: the tool touched tissue in the last 0.1 s
};

// To be called after a step: updates everything except `played` and `times`. simulation.keepLook()
// must have been called before the step. `before`: volume of the tissue before the operation, m^3.
void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before);

}  // namespace resect
