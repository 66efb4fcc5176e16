// The data of an operation that the window shows in its panels: counts, volumes, forces, times.
// The surface is not among them.
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
#include "operation/smoke/smoke_plume.h"
#include "simulation/simulation.h"

namespace resect {

// A segment of vessels on which a clip sits.
struct ClippedVessel {
  std::int32_t organ = 0, segment = -1;
  double radius = 0;  // m

  bool operator==(const ClippedVessel&) const = default;
};

// The state after the newest frame.
struct LiveState {
  std::int64_t frame = 0;
  double time = 0;         // simulated, s
  double lastRemoval = 0;  // steadySeconds() at the last removal of particles, s; 0: none
  // Numbers of particles left, of particles removed so far, and of triangles of the surfaces.
  std::int64_t particles = 0, removed = 0, triangles = 0;
  std::shared_ptr<const Ledger> ledger;  // at most about a second old; null without LedgerWatch
  double removedVolume = 0, volume = 0;  // m^3, of the removed and of the remaining tissue
  float iso = 50;                        // iso level of the first organ
  bool moves = false;                    // whether any tissue is elastic
  bool canBreathe = false;               // whether the simulation has breathing
  bool breathes = false;                 // whether the breathing is on now (Breath::on)
  std::vector<std::string> faults;       // since the last LiveOperation::take(), each once
  // The tools' inputs while a motion plays or a moment of the history is shown. Otherwise empty:
  // the user's hand moves the tools (LiveOperation::setTool()).
  std::vector<ToolInput> played;
  Moment moment;         // the place of this state in the history
  bool showing = false;  // a moment of the history is shown: no new frame begins until goOn()
  // While showing: seconds of the operation per second of real time; 0: no playback.
  double playback = 0;
  // Numbers of strokes (strokes.h) that can be undone and redone.
  int undoable = 0, redoable = 0;
  std::int64_t answered = 0;     // number of the last request that was done (LiveOperation::undo())
  std::size_t historyBytes = 0;  // memory for the states of the history
  std::shared_ptr<const Timeline> timeline;  // at most 15 frames old
  StepTimes times;
  bool bleeds = false;  // whether any organ has vessels
  // bled: blood lost so far, m^3. bleedingRate: blood lost per time, mean over 1 s, m^3/s.
  double bled = 0, bleedingRate = 0;
  double air = 0;                             // volume of air drawn into hepatic veins so far, m^3
  double bloodTime = 0;                       // simulated time of bled and bleedingRate, s
  std::vector<BleedingEnd> bleedingEnds;      // vessels' ends that bleed
  std::vector<ClippedVessel> clips;           // vessels with clips, one entry per clip
  bool inflowClamped = false;                 // whether an organ's inflow of blood is clamped now
  double clampedTime = 0;                     // total time with clamped inflow, s
  std::shared_ptr<const LooseBlood> loose;    // blood on no organ; null: none
  std::shared_ptr<const BareVessels> bare;    // null: no bare vessels and no clips
  std::shared_ptr<const SurfaceCopy> adnexa;  // what hangs on the organ (Adnexa); null: nothing
  SmokePlume smoke;
  // The lists below have one element per tool. In their comments, "it" is the tool.
  std::vector<Pose> poses;           // its present pose, world
  std::vector<std::uint8_t> inHand;  // 1: in hand, or left holding or pressing
  std::vector<std::uint8_t> moved;   // 1: it moved in the last frame
  std::vector<TipPlace> tips;        // valid only while the tool is in hand
  std::vector<double> squeeze;       // of its jaws: 0 wide open, 1 closed
  std::vector<double> bloody;        // length that is bloody, from the tip, m (followBlood())
  std::vector<double> forces;        // smoothed force of the tissue on the tool, N
  std::vector<double> peakForces;    // largest value so far of a frame's mean force, N
  std::vector<double> lastTouch;  // simulated time when the tool last touched tissue, s; -1: never
  std::vector<std::uint8_t> touching;  // 1: the tool touched tissue in the last 0.1 s
  std::vector<std::uint8_t> grips;     // 1: it holds tissue that moves with it
};

// To be called after a step: sets counts, volumes, faults, blood and the lists of `state` from the
// simulation and its report. simulation.keepLook() must have been called before the step. before:
// volume of the tissue before the operation, m^3. peaks: OperationHistory::peaks().
void noteStep(LiveState& state, const Simulation& simulation, const StepReport& report,
              double before, const std::vector<double>& peaks);
// Does the same after the simulation was brought to another moment, for which there is no report.
void noteMoment(LiveState& state, const Simulation& simulation, double before,
                const std::vector<double>& peaks);

}  // namespace resect
