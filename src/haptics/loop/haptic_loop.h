// The loop of 1 kHz between hands and simulation, on a thread of its own.
//
// In each cycle it reads where each hand is, evaluates the newest local model there, lets the
// passivity guard look at the force, and writes it. The simulation gives models and takes poses
// through triple buffers, so neither waits for the other: the loop keeps its pace while the
// simulation is slow, or has stopped.
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

// What a cycle did for one hand.
struct HapticSample {
  float time = 0;               // since the start of the loop, s
  Vec3f force = Vec3f::Zero();  // written, N
  float correction = 0;         // of the model that arrived in this cycle, N; 0: none
  bool still = false;           // the hand wants to hold the instrument still
};

// Results of a loop that has ended.
struct HapticTimes {
  std::int64_t cycles = 0;      // that were due
  std::int64_t missed = 0;      // of them: not finished 1 ms after they were due
  std::vector<float> lateness;  // how late each cycle began, s
  RealTimeRights rights;
};

// Where the person wants the instrument, and whether it is to stay there; for devices that play a
// person. time: since the start of the loop, s.
struct HandIntent {
  Pose pose;
  bool still = false;
};
using IntentAt = std::function<HandIntent(std::size_t hand, double time)>;

class HapticLoop {
 public:
  // devices: one per hand. seconds: for how long memory for samples is set aside; afterwards the
  // loop goes on without keeping any. intent: may be empty; called once here and then on the loop's
  // thread, where it must not allocate. Starts at once; each hand has a pose when the constructor
  // returns.
  HapticLoop(std::vector<std::unique_ptr<HapticDevice>> devices, double seconds, IntentAt intent);
  ~HapticLoop();  // stops, writes zero forces and waits for the thread

  // For the simulation's thread. A hand's newest pose; a model for it.
  const Pose& pose(std::size_t hand);
  void give(std::size_t hand, const LocalModel& model);
  double time() const;  // since the start of the loop, s
  // Throws the Error with which the loop has ended, if it has.
  void check();

  // Stops the loop. Then its results may be read. Throws the Error with which it has ended.
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
