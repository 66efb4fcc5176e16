// What a thread asks of the system so that it wakes up in time: priority, memory that is never
// swapped out, and exact sleep.
#pragma once

namespace resect {

// What the system has permitted.
struct RealTimeRights {
  bool priority = false;      // priority over all threads without real-time priority (SCHED_FIFO)
  bool lockedMemory = false;  // the program's memory stays in RAM
};

// Asks for both, for the calling thread; goes on without those that are refused. While the object
// exists the memory stays locked.
class RealTimeThread {
 public:
  RealTimeThread();
  ~RealTimeThread();
  RealTimeThread(const RealTimeThread&) = delete;
  RealTimeThread& operator=(const RealTimeThread&) = delete;
  const RealTimeRights& rights() const { return rights_; }

 private:
  RealTimeRights rights_;
};

// Sleeps until that time of steadySeconds() (base/stage_clock.h), s; returns at once if it is past.
void sleepUntil(double time);

}  // namespace resect
