// Lets long work be stopped from outside, by Ctrl-C or a button.
//
// A thread registers a flag by which its work can be stopped (StopBy). parallelFor() checks the
// flag before each block, and moveTissues(), which moves the tissue of a frame, checks the flag
// before each time step. Both throw Cancelled if the flag is set. Without a flag, work cannot be
// stopped. Results do not depend on whether there is a flag. If an object was being changed when
// the work was stopped, the object is left half changed. Destroy it, or restore it from a saved
// state.
#pragma once

#include <atomic>

namespace resect {

// Makes `flag` the flag of this thread as long as this object lives. Afterwards the thread has its
// previous flag again.
class StopBy {
 public:
  explicit StopBy(const std::atomic<bool>& flag);
  ~StopBy();
  StopBy(const StopBy&) = delete;
  StopBy& operator=(const StopBy&) = delete;

 private:
  const std::atomic<bool>* before_;
};

// This thread's flag, or null.
const std::atomic<bool>* stopFlag();
// Throws Cancelled (base/progress.h) if this thread's flag is set. To be called in long loops that
// parallelFor() does not run.
void checkStop();

}  // namespace resect
