// How does a person at a terminal see that long work goes on?
#pragma once

#include <string>

#include "base/progress.h"

namespace resect {

// A bar on standard error, drawn only at a terminal and only once the work has taken more than a
// second, or the seconds that have passed while nobody knows the share; Ctrl-C cancels the work
// cleanly while the returned function is in use. The bar is wiped at share 1.
Progress progressBar(const std::string& title);

}  // namespace resect
