// Requests the rights that a thread needs to wake up in time. These are real-time priority, and
// memory that is never swapped out. This header also has a function that sleeps with high
// precision.
#pragma once

namespace resect {

// The rights that the system has granted.
struct RealTimeRights {
  bool priority = false;      // the calling thread has real-time priority (SCHED_FIFO)
  bool lockedMemory = false;  // the program's memory is never swapped out
};

// The constructor requests real-time priority for the calling thread, and locked memory for the
// whole program. If the system refuses a right, this is not an error. The memory stays locked while
// the object exists.
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

// Sleeps until steadySeconds() (base/stage_clock.h) reaches `time`, s. Returns at once if this time
// has passed already.
void sleepUntil(double time);

}  // namespace resect
