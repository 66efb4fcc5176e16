// How is work spread over threads without changing its result?
//
// parallelFor runs body(begin, end) over fixed blocks of [0, count); block borders depend on
// `count` and `grain` alone, never on the number of threads, so a body that writes only to its own
// indices, or reduces per block, gives the same bits at any number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace resect {

// Limits how many threads parallelFor uses while it lives; threads >= 1, 0 = all the machine has.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

using RangeBody = std::function<void(std::size_t begin, std::size_t end)>;

// grain >= 1: indices per block. An empty range does nothing. Exceptions of the body are passed on.
void parallelFor(std::size_t count, std::size_t grain, const RangeBody& body);

}  // namespace resect
