// The haptic loop: it runs at 1 kHz between hands and simulation, on a thread of its own.
//
// In each cycle the loop does the following for each hand. It reads the hand's pose from the
// device, and evaluates the newest local model at this pose (haptics/local_model.h). A passivity
// guard limits the resulting force (haptics/passivity_guard.h), and the loop writes the limited
// force to the device. The deadline of a cycle is 1 ms after the time at which the cycle is due.
// Models and poses are exchanged with the simulation through triple buffers. So the loop never
// waits for the simulation, and keeps its rate even if the simulation is slow or has stopped.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "haptics/device/haptic_device.h"
#include "haptics/hand_cycle.h"
#include "haptics/loop/real_time.h"
#include "haptics/triple_buffer.h"

namespace resect {

// Results of one cycle for one hand.
struct HapticSample {
  float time = 0;               // time since the start of the loop, s
  Vec3f force = Vec3f::Zero();  // force that was written to the device, N
  float correction = 0;         // ForceRenderer::correction(), N; 0 if no model has arrived
  bool still = false;           // HandIntent::still; false if there is no HandIntent
};

// Results of a loop that has ended.
struct HapticTimes {
  std::int64_t cycles = 0;      // number of cycles that were due
  std::int64_t missed = 0;      // cycles that were left out, or that missed their deadline
  std::vector<float> lateness;  // lateness of the start of each cycle that was run, s
  RealTimeRights rights;
};

// What a hand is to do. Only devices that play a person use this (HapticDevice::plays()).
struct HandIntent {
  Pose pose;           // wanted pose of the instrument, in the device's coordinates
  bool still = false;  // whether the hand is to hold the instrument still
};
// hand: number of the hand, from 0. time: time since the start of the loop, s.
using IntentAt = std::function<HandIntent(std::size_t hand, double time)>;

class HapticLoop {
 public:
  // Starts the loop. When the constructor returns, pose() of each hand is valid. devices: one
  // device per hand. seconds: the loop keeps the samples of the first `seconds` s, and drops later
  // ones. The constructor allocates the memory for these samples. intent: may be empty. The
  // constructor calls `intent` once for each hand. All later calls come from the loop's thread; in
  // these calls `intent` must not allocate memory.
  HapticLoop(std::vector<std::unique_ptr<HapticDevice>> devices, double seconds, IntentAt intent);
  // Stops the loop and waits for its thread. When the loop stops, it sets all forces to zero.
  ~HapticLoop();

  // Only the simulation's thread may call pose() and give(). pose() returns the hand's newest pose,
  // in the device's coordinates. give() passes a new local model to the loop; the model must be in
  // the device's coordinates, too.
  const Pose& pose(std::size_t hand);
  void give(std::size_t hand, const LocalModel& model);
  double time() const;  // time since the start of the loop, s
  // If the loop has ended with an Error, throws that Error.
  void check();

  // Stops the loop. After that, the results of the functions below may be read. If the loop has
  // ended with an Error, throws that Error.
  void stop();
  const HapticTimes& times() const { return times_; }
  const std::vector<HapticSample>& samples(std::size_t hand) const;
  const PassivityGuard& guard(std::size_t hand) const;
  std::size_t hands() const { return hands_.size(); }

 private:
  struct Hand;
  void run();
  void cycle(double now, double time);

  std::vector<std::unique_ptr<Hand>> hands_;
  IntentAt intent_;
  HapticTimes times_;
  double start_ = 0;
  std::atomic<bool> stopping_ = false, failed_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace resect
