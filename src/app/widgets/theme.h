// Dark and light colours of the panels.
#pragma once

namespace resect {

// Sets the dark or the light colours for all windows of the program.
void setTheme(bool dark);

}  // namespace resect
