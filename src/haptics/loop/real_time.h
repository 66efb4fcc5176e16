// Requests the rights that a thread needs to wake up in time: real-time priority and memory that is
// never swapped out. Also gives a sleep of high precision.
#pragma once

namespace resect {

// The rights that the system has granted.
struct RealTimeRights {
  bool priority = false;      // priority over all threads without real-time priority (SCHED_FIFO)
  bool lockedMemory = false;  // the program's memory stays in RAM
};

// The constructor requests both rights: priority for the calling thread, locked memory for the
// whole program. A refused right is no error. The memory stays locked while the object exists.
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

// Sleeps until steadySeconds() (base/stage_clock.h) reaches `time`, s; returns at once if it has
// already.
void sleepUntil(double time);

}  // namespace resect
