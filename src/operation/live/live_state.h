// The state of an operation besides its surface, for panels: counts, volumes, forces, times.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "operation/live/step_times.h"
#include "operation/live/tip_place.h"
#include "simulation/simulation.h"

namespace resect {

// The newest state.
struct LiveState {
  std::int64_t frame = 0;
  double time = 0;         // simulated, s
  double lastRemoval = 0;  // s of the steady clock: when a frame last took particles away
  std::int64_t particles = 0, removed = 0, triangles = 0;
  double removedVolume = 0, volume = 0;  // m^3
  float iso = 50;
  bool moves = false;               // the tissue is elastic
  std::vector<std::string> faults;  // since the last take(), each once
  std::vector<ToolInput> played;    // tool inputs by a motion; empty: none is played
  StepTimes times;
  // One per tool.
  std::vector<TipPlace> tips;          // meaningful for those in hand
  std::vector<double> squeeze;         // of its jaws
  std::vector<double> forces;          // smoothed force of the tissue on it, N
  std::vector<double> peakForces;      // largest mean force of a frame so far, N
  std::vector<double> lastTouch;       // simulated time when it last touched tissue, s; -1 never
  std::vector<std::uint8_t> touching;  // 1 if that was within the last 0.1 s
};

// Updates everything except `played` and `times` after a step; keepLook() must be on. `before`:
// volume of the tissue before the operation, m^3.
void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before);

}  // namespace resect
