// The state of an operation besides its surface, for panels: counts, volumes, forces, times.
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
  double lastRemoval = 0;  // when a frame last removed particles, steady clock, s
  std::int64_t particles = 0, removed = 0, triangles = 0;
  double removedVolume = 0, volume = 0;  // m^3
  float iso = 50;
  bool moves = false;               // the tissue is elastic
  std::vector<std::string> faults;  // since the last LiveOperation::take(), each once
  std::vector<ToolInput> played;    // inputs of a motion that plays; empty: none plays
  StepTimes times;
  // One per tool.
  std::vector<TipPlace> tips;          // meaningful only while the tool is in hand
  std::vector<double> squeeze;         // of its jaws: 0 wide open, 1 closed
  std::vector<double> forces;          // smoothed force of the tissue on it, N
  std::vector<double> peakForces;      // largest of its forces so far, each the mean of a frame, N
  std::vector<double> lastTouch;       // simulated time when it last touched tissue, s; -1 never
  std::vector<std::uint8_t> touching;  // 1 if lastTouch is within the last 0.1 s
};

// Updates everything except `played` and `times` after a step. simulation.keepLook() must have been
// called. `before`: volume of the tissue before the operation, m^3.
void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before);

}  // namespace resect
