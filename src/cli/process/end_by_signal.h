// Removes the program's temporary files when a signal ends the program.
#pragma once

namespace resect {

// To be called once, when the program starts. Installs handlers for all signals that would end the
// program and that can be caught. A handler removes the temporary files
// (io/output/temporary_file.h) and the progress bar; then the program ends by that signal. Signals
// that were ignored when the program was started stay ignored.
void cleanUpOnSignals();

}  // namespace resect
