// Parallel loops whose results do not depend on the number of threads.
//
// parallelFor runs body(begin, end) over fixed blocks of [0, count); block borders depend on
// `count` and `grain` alone, never on the number of threads, so a body that writes only to its own
// indices, or reduces per block, gives the same bits at any number of threads.
#pragma once

#include <cstddef>
#include <memory>

namespace resect {

// Limits how many threads parallelFor uses during its lifetime; threads >= 1, 0 = all the machine
// has. Of several at once the lowest holds.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

// How many threads parallelFor may use now: for sizing buffers, never for anything that changes
// results.
std::size_t threadsAllowed();

// What parallelFor runs: refers to a callable (begin, end) that lives at least as long as the call.
// Unlike a std::function it never allocates.
class RangeBody {
 public:
  template <typename Callable>
  RangeBody(const Callable& callable)
      : callable_(std::addressof(callable)),
        call_([](const void* body, std::size_t begin, std::size_t end) {
          (*static_cast<const Callable*>(body))(begin, end);
        }) {}
  void operator()(std::size_t begin, std::size_t end) const { call_(callable_, begin, end); }

 private:
  const void* callable_;
  void (*call_)(const void*, std::size_t, std::size_t);
};

// grain >= 1: indices per block. An empty range does nothing. Exceptions of the body are passed on.
void parallelFor(std::size_t count, std::size_t grain, const RangeBody& body);

}  // namespace resect
