#include "haptics/loop/real_time.h"

#include <pthread.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>

#include <cerrno>
#include <cmath>

namespace resect {
namespace {

// Above the program's other threads, below the kernel's own (50).
constexpr int kPriority = 40;

}  // namespace

RealTimeThread::RealTimeThread() {
  sched_param wanted{};
  wanted.sched_priority = kPriority;
  rights_.priority = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0;
  // Without that priority the system may round wake-ups by 50 us to save power.
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  // With a limit on locked memory, locking what comes later would make allocations fail.
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY)
    rights_.lockedMemory = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
}

RealTimeThread::~RealTimeThread() {
  if (rights_.lockedMemory) munlockall();
}

void sleepUntil(double time) {
  timespec wake{};
  wake.tv_sec = time_t(std::floor(time));
  wake.tv_nsec = long((time - std::floor(time)) * 1e9);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
  }
}

}  // namespace resect
