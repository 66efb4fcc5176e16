// Progress bar for long work at a terminal.
#pragma once

#include <string>

#include "base/progress.h"

namespace resect {

// A bar, or the elapsed seconds while the share is unknown, on standard error; only at a terminal
// and after more than a second of work. Ctrl-C cancels the work cleanly while the returned function
// is in use. The bar is erased at share 1.
Progress progressBar(const std::string& title);

}  // namespace resect
