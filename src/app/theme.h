// Dark and light colours of the panels.
#pragma once

namespace resect {

// Applies to all windows of the program.
void setTheme(bool dark);

}  // namespace resect
