#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "base/progress.h"
#include "base/stop.h"

#ifdef RESECT_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#else
#include <exception>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>
#endif

namespace resect {
namespace {

std::size_t threadsMeant(int threads) {
  return threads > 0 ? std::size_t(threads) : std::max(1u, std::thread::hardware_concurrency());
}

// Runs blocks by their number, on any thread, unless the work of the thread that made it is to
// stop.
struct Blocks {
  std::size_t count, grain;
  const RangeBody& body;
  const std::atomic<bool>* stop = stopFlag();

  void operator()(std::size_t block) const {
    if (stop && stop->load(std::memory_order_relaxed)) throw Cancelled{};
    body(block * grain, std::min(count, (block + 1) * grain));
  }
};

}  // namespace

#ifdef RESECT_TBB

ThreadLimit::ThreadLimit(int threads)
    : control_(new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                       threadsMeant(threads))) {}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

std::size_t threadsAllowed() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

void parallelFor(std::size_t count, std::size_t grain, const RangeBody& body) {
  const std::size_t blocks = (count + grain - 1) / grain;
  const Blocks run{count, grain, body};
  // One thread needs no scheduler.
  if (blocks <= 1 || threadsAllowed() <= 1)
    for (std::size_t block = 0; block < blocks; ++block) run(block);
  else
    tbb::parallel_for(std::size_t(0), blocks, run);
}

#else

// Without oneTBB: threads of the standard library, started anew for each loop. So does the build
// for the thread sanitizer, which reports false races in a oneTBB library built without it.
namespace {
std::atomic<std::size_t> threadLimit{0};  // 0: none
thread_local bool inLoop = false;         // loops within loops start no threads
}  // namespace

ThreadLimit::ThreadLimit(int threads) : control_(new std::size_t(threadLimit)) {
  threadLimit =
      threadLimit ? std::min(threadLimit.load(), threadsMeant(threads)) : threadsMeant(threads);
}

ThreadLimit::~ThreadLimit() {
  auto* before = static_cast<std::size_t*>(control_);
  threadLimit = *before;
  delete before;
}

std::size_t threadsAllowed() {
#ifdef __SANITIZE_THREAD__
  constexpr std::size_t kLeast = 2;  // so that thread errors can show on a machine of one core
#else
  constexpr std::size_t kLeast = 1;
#endif
  return threadLimit ? threadLimit.load() : std::max(kLeast, threadsMeant(0));
}

void parallelFor(std::size_t count, std::size_t grain, const RangeBody& body) {
  const std::size_t blocks = (count + grain - 1) / grain;
  const std::size_t most = std::min(inLoop ? 1 : threadsAllowed(), blocks);
  const Blocks run{count, grain, body};
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    const bool outer = std::exchange(inLoop, true);
    for (std::size_t block = next++; block < blocks; block = next++) try {
        run(block);
      } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
      }
    inLoop = outer;
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t i = 1; i < most; ++i) others.emplace_back(work);
    } catch (const std::system_error&) {
      // No more threads can be started: the present ones do the work.
    }
    work();
  }
  if (error) std::rethrow_exception(error);
}

#endif

}  // namespace resect
