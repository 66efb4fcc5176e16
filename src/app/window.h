// The interactive window.
#pragma once

#include <optional>
#include <string>

#include "operation/scenario.h"

namespace resect {

struct WindowOptions {
  Scenario scenario;  // organ and room to begin with
  int width = 1280, height = 720;
  double fpsLimit = 60;
  bool overlay = true;       // show the controls at the start
  bool reports = false;      // report events on standard output, for scripts
  std::optional<bool> dark;  // none: the theme chosen last; dark at the very first start
};

// Opens the window and returns its exit status when it is closed. Throws Error when there is no
// display or no OpenGL.
int showWindow(const WindowOptions& options);

}  // namespace resect
