// Runs a scenario in real time while haptic devices hold its instruments. Measures the forces on
// the hands, and how late the cycles of the haptic loop and the frames of the simulation are. In
// the haptic loop, the force on a hand is computed from the local model of the instrument
// (haptics/local_model.h).
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

// Results for one instrument that is held by a device.
struct HandReport {
  std::string tool;
  ForceNoise noise;
  double peakForce = 0;      // N
  double peakStiffness = 0;  // largest stiffness of a local model in any direction, N/m
  double largestStep = 0;    // largest change of the force from one cycle to the next, N
  // Rms of those values of ForceRenderer::correction() that are above 0, N.
  double correction = 0;
  double energy = 0;         // work on the hand in the whole run, J; below 0: the hand gave energy
  double mostEnergy = 0;     // largest value of this work during the run, J, >= 0
  std::int64_t guarded = 0;  // cycles in which the passivity guard reduced the force
};

struct HapticsReport {
  double seconds = 0;                   // duration of the run, s
  std::int64_t cycles = 0, missed = 0;  // as in HapticTimes (haptics/loop/haptic_loop.h)
  // Lateness of the starts of cycles, s: median, 99th percentile and maximum.
  double p50 = 0, p99 = 0, latest = 0;
  RealTimeRights rights;
  std::int64_t frames = 0;      // number of frames that the simulation has computed
  std::int64_t lateFrames = 0;  // number of frames that took longer than frameDuration
  double frameDuration = 0;     // simulated time of a frame, s
  TimeSummary frame;            // computing times of frames, local models included
  std::vector<HandReport> hands;

  // Fraction of the cycles that met their deadline, 0 to 1.
  double met() const { return cycles > 0 ? double(cycles - missed) / double(cycles) : 0; }
};

struct HapticsSetup {
  double seconds = 60;  // duration of the run, s, 1 to 3600
  std::string options;  // text for the plug-in
  // Name of the only instrument that a device holds. If it is empty, devices hold all instruments
  // that the scenario moves.
  std::string tool;
};

// The scenario's motions are repeated until setup.seconds have passed. Each repetition begins with
// the simulation's initial state. A device may play a person, that is, simulate the hand
// (HapticDevice::plays()). Such a device gets the pose that the instrument should have in the
// scenario, in world coordinates. With any other device a person moves the instrument. In this case
// the origin of the device's workspace is at the position that the instrument has at the start of
// its motion in the scenario. `progress` gets the fraction of the time that has passed, 0 to 1.
// Throws Error if a device fails, or if the scenario does not move the instrument setup.tool. If
// setup.tool is empty, throws Error if the scenario moves no instrument at all.
HapticsReport benchHaptics(Simulation& simulation, const Scenario& scenario,
                           const HapticPlugin& plugin, const HapticsSetup& setup,
                           const std::function<void(double)>& progress = {});

}  // namespace resect
