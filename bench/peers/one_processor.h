// Keeps a process, its children and its renderer's threads on one core.
#pragma once

#include <sched.h>

namespace resect::bench {

// While it lives, all threads and children of this process run on the processor that it is made on.
class OneProcessor {
 public:
  OneProcessor();
  ~OneProcessor();
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_ = {};
};

}  // namespace resect::bench
