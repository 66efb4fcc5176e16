// The state of an operation that the window shows in its panels: counts, volumes, forces, times.
// The surface is not part of it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "operation/blood/bare_vessels.h"
#include "operation/blood/bloody_tools.h"
#include "operation/blood/loose_blood.h"
#include "operation/ledger/ledger.h"
#include "operation/live/step_times.h"
#include "operation/live/timeline.h"
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
  std::shared_ptr<const Ledger> ledger;  // at most a second old; null if none was asked for
  double removedVolume = 0, volume = 0;  // volume of removed tissue; volume of the tissue left; m^3
  float iso = 50;                        // iso level
  bool moves = false;                    // whether any tissue is elastic
  std::vector<std::string> faults;       // since the last LiveOperation::take(), each once
  // The tools' inputs while something else than the hand moves them: a motion that plays, or a
  // moment of the history that is shown. Empty: the hand moves them.
  std::vector<ToolInput> played;
  Moment moment;         // the end of the newest frame in the history
  bool showing = false;  // a moment of the history is shown: nothing happens until goOn()
  double playback = 0;   // while showing: seconds of the operation per second; 0: no playback
  int undoable = 0, redoable = 0;  // strokes that can be taken back; that can be done again
  std::int64_t answered = 0;     // number of the last request that was done (LiveOperation::undo())
  std::size_t historyBytes = 0;  // memory for the states of the history
  std::shared_ptr<const Timeline> timeline;  // renewed several times a second
  StepTimes times;
  bool bleeds = false;                      // whether any organ has vessels
  double bled = 0, bleedingRate = 0;        // so far, m^3; mean over about a second, m^3/s
  double bloodTime = 0;                     // of these, s
  std::vector<BleedingEnd> bleedingEnds;    // vessels' ends that bleed
  int clips = 0;                            // on vessels
  std::shared_ptr<const LooseBlood> loose;  // on the table and in the air; null: none
  std::shared_ptr<const BareVessels> bare;  // null: none
  // The lists below have one element per tool.
  std::vector<Pose> poses;           // where it is
  std::vector<std::uint8_t> inHand;  // 1: it is in hand, or left holding or pressing
  std::vector<std::uint8_t> moved;   // 1: it moved in the last frame
  std::vector<TipPlace> tips;        // valid only while the tool is in hand
  std::vector<double> squeeze;       // of its jaws: 0 wide open, 1 closed
  std::vector<double> bloody;        // m from its tip (operation/blood/bloody_tools.h)
  std::vector<double> forces;        // smoothed force of the tissue on the tool, N
  std::vector<double> peakForces;    // largest so far of the mean forces in a frame, N
  std::vector<double> lastTouch;  // simulated time when the tool last touched tissue, s; -1: never
  std::vector<std::uint8_t> touching;  // 1: the tool touched tissue in the last 0.1 s
};

// To be called after a step: takes counts, volumes, faults and the lists from the simulation and
// its report. simulation.keepLook() must have been called before the step. `before`: volume of the
// tissue before the operation, m^3. peaks: OperationHistory::peaks().
void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before, const std::vector<double>& peaks);
// The same after the simulation was brought to another moment. There is no report then.
void noteMoment(LiveState& state, const Simulation& simulation, double before,
                const std::vector<double>& peaks);

}  // namespace resect
