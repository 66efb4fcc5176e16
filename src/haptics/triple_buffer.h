// A triple buffer: hands the newest value of one thread to another, without a lock.
//
// One thread writes, one other thread reads. Neither ever waits for the other, and the reader never
// sees a value that is half written. Values that the reader was too slow to read are overwritten.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace resect {

template <typename T>
class TripleBuffer {
 public:
  // Writer: the value to fill before publish(). Until then it holds an older value.
  T& draft() { return slots_[writing_].value; }
  // Writer: makes draft() the newest value.
  void publish() {
    writing_ =
        waiting_.exchange(std::uint8_t(writing_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }
  void publish(const T& value) {
    draft() = value;
    publish();
  }

  // Reader: makes newest() the last value published. Returns whether the reader had not seen it
  // yet.
  bool update() {
    if (!(waiting_.load(std::memory_order_relaxed) & kFresh)) return false;
    reading_ = waiting_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  // Reader: the value as of the last update(); before the first one a default value.
  const T& newest() const { return slots_[reading_].value; }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  static constexpr std::size_t kCacheLine = 64;
  struct alignas(kCacheLine) Slot {
    T value{};
  };
  std::array<Slot, 3> slots_;
  alignas(kCacheLine) std::uint8_t writing_ = 0;
  alignas(kCacheLine) std::uint8_t reading_ = 1;
  // Index of the slot that neither thread uses; with kFresh if the reader has not seen its value.
  alignas(kCacheLine) std::atomic<std::uint8_t> waiting_ = 2;
};

}  // namespace resect
