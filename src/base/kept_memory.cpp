#include "base/kept_memory.h"

#include <cstdlib>  // defines the macro that names the C library

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace resect {

void keepFreedMemory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest value it accepts
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

}  // namespace resect
