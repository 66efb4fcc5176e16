// Lets long work be stopped from outside, by Ctrl-C or a button.
//
// A thread names the flag by which its work can be stopped. parallelFor() looks at it before each
// block, a frame of tissue before each substep, and throws Cancelled. Without a flag nothing ever
// stops, and results are the same either way. What was being changed when work stopped is half
// changed: destroy it, or restore it from a saved state.
#pragma once

#include <atomic>

namespace resect {

// The flag of this thread during its lifetime; afterwards that of before.
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
// Throws Cancelled (base/progress.h) if this thread's flag is set. For loops that parallelFor()
// does not run.
void checkStop();

}  // namespace resect
