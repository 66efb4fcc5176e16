#include "base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <thread>

namespace resect {

ThreadLimit::ThreadLimit(int threads)
    : control_(new tbb::global_control(
          tbb::global_control::max_allowed_parallelism,
          threads > 0 ? std::size_t(threads) : std::max(1u, std::thread::hardware_concurrency()))) {
}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

void parallelFor(std::size_t count, std::size_t grain, const RangeBody& body) {
  const std::size_t blocks = (count + grain - 1) / grain;
  if (blocks <= 1) {
    if (count > 0) body(0, count);
    return;
  }
  tbb::parallel_for(std::size_t(0), blocks, [&](std::size_t block) {
    body(block * grain, std::min(count, (block + 1) * grain));
  });
}

}  // namespace resect
