#include "haptics/loop/haptic_loop.h"

#include <algorithm>
#include <cmath>

#include "base/stage_clock.h"

namespace resect {
struct HapticLoop::Hand {
  std::unique_ptr<HapticDevice> device;
  HandCycle cycle;
  TripleBuffer<LocalModel> models;
  TripleBuffer<Pose> poses;
  std::vector<HapticSample> samples;  // its memory is set aside

  Hand(std::unique_ptr<HapticDevice> d, const Pose& start, double now)
      : device(std::move(d)), cycle(device->mostForce(), start, now) {
    poses.publish(start);
    poses.update();
  }
};

HapticLoop::HapticLoop(std::vector<std::unique_ptr<HapticDevice>> devices, double seconds,
                       IntentAt intent)
    : intent_(std::move(intent)) {
  const auto cycles = std::size_t(std::max(0.0, seconds) / kHapticPeriod);
  for (auto& device : devices) {
    if (intent_) device->intend(intent_(hands_.size(), 0).pose);
    const Pose pose = device->read();
    hands_.push_back(std::make_unique<Hand>(std::move(device), pose, steadySeconds()));
    hands_.back()->samples.assign(cycles, {});  // touches the memory
    hands_.back()->samples.clear();
  }
  times_.lateness.assign(cycles, 0);
  times_.lateness.clear();
  start_ = steadySeconds();
  thread_ = std::thread([this] { run(); });
}

HapticLoop::~HapticLoop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

const Pose& HapticLoop::pose(std::size_t hand) {
  hands_[hand]->poses.update();
  return hands_[hand]->poses.newest();
}

void HapticLoop::give(std::size_t hand, const LocalModel& model) {
  hands_[hand]->models.publish(model);
}

double HapticLoop::time() const { return steadySeconds() - start_; }

void HapticLoop::check() {
  if (failed_) stop();
}

void HapticLoop::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
  if (failure_) std::rethrow_exception(failure_);
}

const std::vector<HapticSample>& HapticLoop::samples(std::size_t hand) const {
  return hands_[hand]->samples;
}

const PassivityGuard& HapticLoop::guard(std::size_t hand) const {
  return hands_[hand]->cycle.guard();
}

void HapticLoop::run() {
  try {
    const RealTimeThread thread;
    times_.rights = thread.rights();
    std::int64_t number = 1;
    while (!stopping_) {
      const double due = start_ + double(number) * kHapticPeriod;
      sleepUntil(due);
      const double now = steadySeconds();
      cycle(now, now - start_);
      const double done = steadySeconds();
      if (times_.lateness.size() < times_.lateness.capacity())
        times_.lateness.push_back(float(now - due));
      // Cycles whose time has passed meanwhile are left out; each is a deadline missed.
      const auto next =
          std::max(number + 1, std::int64_t(std::ceil((done - start_) / kHapticPeriod)));
      times_.cycles += next - number;
      times_.missed += next - number - 1 + (done > due + kHapticPeriod);
      number = next;
    }
  } catch (...) {
    failure_ = std::current_exception();
    failed_ = true;
  }
  // Also after a failure, in which the other devices still hold their forces.
  for (auto& hand : hands_) try {
      hand->device->write({});
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
}

void HapticLoop::cycle(double now, double time) {
  for (std::size_t h = 0; h < hands_.size(); ++h) {
    Hand& hand = *hands_[h];
    HandIntent intent;
    if (intent_) {
      intent = intent_(h, time);
      hand.device->intend(intent.pose);
    }
    const Pose pose = hand.device->read();
    const bool arrived = hand.models.update();
    const Wrench wrench = hand.cycle.next(pose, arrived ? &hand.models.newest() : nullptr, now);
    hand.device->write(wrench);
    hand.poses.publish(pose);
    HapticSample sample;
    if (arrived) sample.correction = float(hand.cycle.renderer().correction());
    sample.time = float(time);
    sample.force = wrench.force.cast<float>();
    sample.still = intent.still;
    if (hand.samples.size() < hand.samples.capacity()) hand.samples.push_back(sample);
  }
}

}  // namespace resect
