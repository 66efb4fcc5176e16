// The loop of 1 kHz between hands and simulation, on a thread of its own.
//
// In each cycle, and for each hand, the loop reads the pose, evaluates the newest local model
// there, limits the force by the passivity guard, and writes it to the device. Models and poses are
// exchanged with the simulation through triple buffers, so neither side waits for the other. The
// loop keeps its pace while the simulation is slow, or has stopped.
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
  float time = 0;               // since the start of the loop, s
  Vec3f force = Vec3f::Zero();  // written to the device, N
  float correction = 0;         // ForceRenderer::correction() if a model has arrived, N; else 0
  bool still = false;           // HandIntent::still; false without an intent
};

// Results of a loop that has ended.
struct HapticTimes {
  std::int64_t cycles = 0;      // number of cycles that were due
  std::int64_t missed = 0;      // of these: left out, or not finished 1 ms after they were due
  std::vector<float> lateness;  // how late each cycle began, s
  RealTimeRights rights;
};

// What the hand is to do; for devices that play a person.
struct HandIntent {
  Pose pose;           // wanted pose of the instrument, in the device's coordinates
  bool still = false;  // the hand is to hold the instrument still
};
// hand: number of the hand, from 0. time: since the start of the loop, s.
using IntentAt = std::function<HandIntent(std::size_t hand, double time)>;

class HapticLoop {
 public:
  // Starts the loop. When the constructor returns, pose() of each hand is valid. devices: one per
  // hand. seconds: duration for which samples are kept; their memory is allocated here. Later
  // cycles keep no samples. intent: may be empty. It is called once per hand here, and then on the
  // loop's thread, where it must not allocate.
  HapticLoop(std::vector<std::unique_ptr<HapticDevice>> devices, double seconds, IntentAt intent);
  ~HapticLoop();  // stops, writes zero forces and waits for the thread

  // For the simulation's thread. pose(): the hand's newest pose, in the device's coordinates.
  // give(): hands a new model, in the same coordinates, to the loop.
  const Pose& pose(std::size_t hand);
  void give(std::size_t hand, const LocalModel& model);
  double time() const;  // since the start of the loop, s
  // If the loop has ended with an Error, throws that Error.
  void check();

  // Stops the loop; after that its results may be read. If the loop has ended with an Error, throws
  // that Error.
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
