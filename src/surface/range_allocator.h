// Allocates ranges of elements in a growing array.
#pragma once

#include <cstdint>
#include <vector>

namespace resect {

// Hands out ranges of a one-dimensional space. Sizes are rounded up to multiples of 8, so that the
// holder of a range may grow a little in place. A request takes the range released last that has
// its rounded size; if there is none, the space grows. Each call costs O(1). The same calls give
// the same ranges.
class RangeAllocator {
 public:
  static constexpr std::int32_t kStep = 8;
  static std::int32_t roundedUp(std::int32_t count) { return (count + kStep - 1) / kStep * kStep; }

  // count >= 1. Returns the first element; the range holds roundedUp(count) elements.
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
  // Releases a range that take() gave for a count of the same rounded size.
  void release(std::int32_t first, std::int32_t count) {
    const std::size_t size = std::size_t(roundedUp(count) / kStep);
    if (size >= free_.size()) free_.resize(size + 1);
    free_[size].push_back(first);
  }
  std::int32_t end() const { return end_; }  // all ranges handed out so far lie below

 private:
  std::int32_t end_ = 0;
  std::vector<std::vector<std::int32_t>> free_;  // released ranges, by rounded size / kStep
};

}  // namespace resect
