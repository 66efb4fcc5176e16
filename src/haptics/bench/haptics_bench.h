// Runs a scenario in real time with its instruments held by haptic devices, and measures the forces
// on the hands and the timing.
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
  double correction = 0;     // rms of ForceRenderer::correction() over all new local models, N
  double energy = 0;         // work on the hand over the run, J; below 0: the hand gave energy
  double mostEnergy = 0;     // largest value of that work at any time, J
  std::int64_t guarded = 0;  // cycles in which the passivity guard reduced the force
};

struct HapticsReport {
  double seconds = 0;                   // duration of the run
  std::int64_t cycles = 0, missed = 0;  // of the loop, as in HapticTimes
  double p50 = 0, p99 = 0, latest = 0;  // how late cycles began, s: quantiles; maximum
  RealTimeRights rights;
  std::int64_t frames = 0;      // computed by the simulation
  std::int64_t lateFrames = 0;  // frames whose computation took longer than frameDuration
  double frameDuration = 0;     // s
  TimeSummary frame;            // computing time of a frame and its local models
  std::vector<HandReport> hands;

  // Share of the cycles that met their deadline, 0 to 1.
  double met() const { return cycles > 0 ? double(cycles - missed) / double(cycles) : 0; }
};

struct HapticsSetup {
  double seconds = 60;  // duration of the run, 1 to 3600
  std::string options;  // text for the plug-in
  std::string tool;     // the only instrument held by a device; "": all that the scenario moves
};

// The scenario's motions are repeated until setup.seconds have passed. Each repetition begins with
// the simulation's initial state. A device that plays a person (HapticDevice::plays()) is told the
// pose that the instrument has in the scenario, in world coordinates. With other devices a person
// moves the instrument: the origin of the device's workspace is at the position of the instrument
// at the first key of its motion (ToolKey). `progress` gets the elapsed share of the time, 0 to 1.
// Throws Error if the scenario does not move setup.tool, or moves no instrument, or if a device
// fails.
HapticsReport benchHaptics(Simulation& simulation, const Scenario& scenario,
                           const HapticPlugin& plugin, const HapticsSetup& setup,
                           const std::function<void(double)>& progress = {});

}  // namespace resect
