// A progress bar for long work at a terminal.
#pragma once

#include <atomic>
#include <string>

#include "base/progress.h"

namespace resect {

// Shows a bar on standard error. While it is unknown which share of the work is done, the elapsed
// seconds are shown instead. The bar appears only at a terminal, and only after more than a second
// of work. The bar is erased when all work is done (share 1), or when the returned function is
// destroyed.
Progress progressBar(const std::string& title);

// Erases the bar, if one is shown. May be called in a signal's handler.
void wipeProgressBar() noexcept;

}  // namespace resect
