// Parallel loops whose results do not depend on the number of threads.
//
// parallelFor runs body(begin, end) over fixed blocks of [0, count). The borders of the blocks
// depend on `count` and `grain` alone, never on the number of threads. So a body that writes only
// to its own indices, or reduces per block, gives the same bits at any number of threads.
#pragma once

#include <cstddef>
#include <memory>

namespace resect {

// While this object exists, parallelFor uses at most `threads` threads; 0: as many threads as the
// machine has. If several of these objects exist at the same time, the lowest limit holds.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

// How many threads parallelFor may use now. Use this number only for the sizes of buffers, and
// never for anything that changes results.
std::size_t threadsAllowed();

// A reference to a function object body(begin, end), which parallelFor calls. The function object
// must exist until the loop ends. Unlike a std::function, a RangeBody never allocates.
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

// grain: number of indices per block, at least 1; the last block may have fewer. With count = 0
// nothing is called. An exception that `body` throws is thrown again to the caller. The loop can be
// stopped as described in base/stop.h.
void parallelFor(std::size_t count, std::size_t grain, const RangeBody& body);

}  // namespace resect
