// Allocates ranges of elements in a growing array.
#pragma once

#include <cstdint>
#include <vector>

namespace resect {

// Hands out ranges of indices. Sizes are rounded up to multiples of 8, so that a range can take up
// to 7 more elements without moving. Among the released ranges of the rounded size, take() gives
// the one that was released last. If there is none, take() gives new indices at the end of the
// array. Each call costs O(1). The same sequence of calls gives the same ranges.
class RangeAllocator {
 public:
  static constexpr std::int32_t kStep = 8;
  static std::int32_t roundedUp(std::int32_t count) { return (count + kStep - 1) / kStep * kStep; }

  // count: at least 1. Returns the first index of a range of roundedUp(count) elements.
  std::int32_t take(std::int32_t count) {
    const std::size_t size = std::size_t(roundedUp(count) / kStep);
    if (size < free_.size() && !free_[size].empty()) {
      const std::int32_t first = free_[size].back();
      free_[size].pop_back();
      return first;
    }
    const std::int32_t first = end_;
    end_ += roundedUp(count);
    return first;
  }
  // Releases the range for which take() returned `first`. `count` must round up to the same size as
  // the count in that call of take().
  void release(std::int32_t first, std::int32_t count) {
    const std::size_t size = std::size_t(roundedUp(count) / kStep);
    if (size >= free_.size()) free_.resize(size + 1);
    free_[size].push_back(first);
  }
  std::int32_t end() const { return end_; }  // first index that was never handed out

 private:
  std::int32_t end_ = 0;
  // Element n: the first indices of the released ranges of size n * kStep.
  std::vector<std::vector<std::int32_t>> free_;
};

}  // namespace resect
