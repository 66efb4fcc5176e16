// How does memory that is used for the first time come without a stop at every fourth kilobyte?
#pragma once

#include <cstddef>

namespace resect {

// Asks the system to put large pages (2 MB) under memory that was allocated and not yet written:
// before the first writing each page of 4 kB is a visit to the system, which takes longer than to
// fill it. A wish: where the system has no large pages to give, nothing changes. Memory of less
// than a large page is left alone.
void wantLargePages(void* begin, std::size_t bytes);

}  // namespace resect
