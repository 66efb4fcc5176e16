// Runs a scenario in real time with its instruments in the hands of haptic devices, and measures
// what the hands get.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "haptics/bench/force_noise.h"
#include "haptics/device/haptic_device.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

// One instrument in a hand.
struct HandReport {
  std::string tool;
  ForceNoise noise;
  double peakForce = 0;      // N
  double peakStiffness = 0;  // largest stiffness of a local model in any direction, N/m
  double largestStep = 0;    // of the force from one cycle to the next, N
  double correction = 0;     // rms of what local models had not foreseen, N
  double energy = 0;         // work on the hand over the run, J; below 0: the hand gave energy
  double mostEnergy = 0;     // the largest value of that work at any time, J
  std::int64_t guarded = 0;  // cycles in which the passivity guard took some force away
};

struct HapticsReport {
  double seconds = 0;                   // of the run
  std::int64_t cycles = 0, missed = 0;  // of the loop; missed: not done within 1 ms
  double p50 = 0, p99 = 0, latest = 0;  // jitter: how late cycles began, s
  RealTimeRights rights;
  std::int64_t frames = 0;      // of the simulation
  std::int64_t lateFrames = 0;  // of these: computing took longer than the frame lasts
  double frameDuration = 0;     // s
  TimeSummary frame;            // time of a frame with its local models
  std::vector<HandReport> hands;

  double met() const { return cycles > 0 ? double(cycles - missed) / double(cycles) : 0; }
};

struct HapticsSetup {
  double seconds = 60;  // 1 to 3600
  std::string options;  // for the plug-in
  std::string tool;     // name of the one instrument in a hand; "": all that the scenario moves
};

// The scenario's motions are repeated until the time is over; each time the simulation begins anew.
// A device that plays a person is told where the scenario wants the instrument; its coordinates are
// those of the world. With other devices a person moves the instrument: the origin of their
// workspace is put at the instrument's first key. `progress` gets the share of the time that is
// over. Throws Error if the scenario moves no such instrument, or a device fails.
HapticsReport benchHaptics(Simulation& simulation, const Scenario& scenario,
                           const HapticPlugin& plugin, const HapticsSetup& setup,
                           const std::function<void(double)>& progress = {});

}  // namespace resect
