// The window in which a person operates with mouse and keyboard.
#pragma once

#include <optional>
#include <string>

#include "operation/scenario.h"

namespace resect {

struct WindowOptions {
  Scenario scenario;               // what the window shows first
  std::string operation;           // recording whose operation is shown instead; empty: none
  int width = 1280, height = 720;  // of the window, pixels
  int historyMemory = 512;         // most memory for showing earlier moments, MB
  double fpsLimit = 60;            // most pictures per second
  bool exercises = false;          // show the list of exercises first
  // Obey the commands of a script on standard input, and report to it on standard output.
  bool reports = false;
  // True: dark colours. False: light colours. Without a value: those chosen last, or dark ones if
  // none were chosen yet.
  std::optional<bool> dark;
};

// Opens the window and waits until it is closed. Returns the exit status, which is 0 if nothing
// failed. Throws Error when there is no display or no OpenGL.
int showWindow(const WindowOptions& options);

}  // namespace resect
