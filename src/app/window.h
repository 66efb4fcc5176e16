// The window in which a person operates with mouse and keyboard.
#pragma once

#include <optional>
#include <string>

#include "operation/scenario.h"

namespace resect {

struct WindowOptions {
  Scenario scenario;               // what the window shows first
  std::string operation;           // recording whose operation is shown instead; empty: none
  int width = 1280, height = 720;  // size of the window, pixels
  int historyMemory = 512;         // most memory for showing earlier moments, MB
  double fpsLimit = 60;            // most pictures per second
  bool exercises = false;          // show the list of exercises first
  // Obey the commands of a script on standard input, and report to it on standard output.
  bool reports = false;
  // True: dark colours. False: light colours. Without a value: the colours that the user chose
  // last; dark colours if the user never chose.
  std::optional<bool> dark;
  std::string language;  // see useLanguage() in app/language/language.h; empty: not given
};

// Opens the window and waits until the user closes it. Returns the exit status: 0 if nothing
// failed. Throws Error when there is no display or no OpenGL.
int showWindow(const WindowOptions& options);

}  // namespace resect
