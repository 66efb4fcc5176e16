// How is a whole process, with what it starts and what drives its graphics, kept to one core?
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
