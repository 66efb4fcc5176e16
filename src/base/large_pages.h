// Requests transparent huge pages.
#pragma once

#include <cstddef>

namespace resect {

// Asks the system to back memory that is allocated and not yet written with huge pages (2 MB): the
// first write to a page of 4 kB is a page fault, which takes longer than filling it. Only advice:
// where the system has no huge pages nothing changes. Ranges of less than a huge page are left
// alone.
void wantLargePages(void* begin, std::size_t bytes);

}  // namespace resect
