// Requests transparent huge pages.
#pragma once

#include <cstddef>

namespace resect {

// Asks the system to use huge pages (2 MB) for memory that is allocated but not yet written. With
// pages of 4 kB, the first write to each page causes a page fault. A page fault takes longer than
// filling the page. The request is only advice: where the system has no huge pages, nothing
// changes. The function does nothing for a range that is shorter than a huge page.
void wantLargePages(void* begin, std::size_t bytes);

}  // namespace resect
