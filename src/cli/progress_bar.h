// Progress bar for long work at a terminal.
#pragma once

#include <string>

#include "base/progress.h"

namespace resect {

// Shows a bar on standard error; while the share is unknown, it shows the elapsed seconds instead.
// The bar appears only at a terminal, and only after more than a second of work. While the returned
// function exists, Ctrl-C cancels the work cleanly. The bar is erased when the share is 1.
Progress progressBar(const std::string& title);

}  // namespace resect
