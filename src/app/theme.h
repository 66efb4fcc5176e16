// What colours have the panels?
#pragma once

namespace resect {

// Of all windows of the program.
void setTheme(bool dark);

}  // namespace resect
