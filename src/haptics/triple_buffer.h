// A triple buffer passes the newest value from one thread to another without a lock.
//
// One thread, the writer, writes values. Another thread, the reader, reads them. Neither thread
// ever waits for the other. The reader never sees a value that is only partly written. If the
// writer is faster than the reader, the reader never sees some of the values.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace resect {

template <typename T>
class TripleBuffer {
 public:
  // For the writer: a place for the next value. The place holds an older value, so overwrite it
  // before you call publish().
  T& draft() { return slots_[writing_].value; }
  // For the writer: makes the value in draft() the newest value.
  void publish() {
    writing_ =
        waiting_.exchange(std::uint8_t(writing_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }
  void publish(const T& value) {
    draft() = value;
    publish();
  }

  // For the reader: makes newest() the value that was published last. Returns whether this value is
  // new for the reader.
  bool update() {
    if (!(waiting_.load(std::memory_order_relaxed) & kFresh)) return false;
    reading_ = waiting_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  // For the reader: the newest value at the time of the last update(). Before the first update() it
  // is a default value.
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
  // Index of the slot that neither thread uses. The bit kFresh is added if the reader has not seen
  // the value in this slot.
  alignas(kCacheLine) std::atomic<std::uint8_t> waiting_ = 2;
};

}  // namespace resect
