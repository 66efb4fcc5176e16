#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace resect {

void assertFailed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "resect: internal error: %s does not hold (%s:%d); please report this\n",
               condition, file, line);
  std::abort();
}

}  // namespace resect
