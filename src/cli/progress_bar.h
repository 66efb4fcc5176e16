// Progress bar for long work at a terminal.
#pragma once

#include <string>

#include "base/progress.h"

namespace resect {

// Shows a bar on standard error, or the elapsed seconds while the share is unknown. It appears only
// at a terminal, and only after more than a second of work. While the returned function exists,
// Ctrl-C cancels the work cleanly. The bar is erased at share 1.
Progress progressBar(const std::string& title);

}  // namespace resect
