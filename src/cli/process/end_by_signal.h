// Leaves no temporary files when a signal ends the program.
#pragma once

namespace resect {

// To be called once, at the start. Every signal that would end the program, but those that cannot
// be caught, then first removes its temporary files (io/output/temporary_file.h) and the progress
// bar; the program still ends by that signal. Signals that it was started to ignore stay ignored.
void cleanUpOnSignals();

}  // namespace resect
