#include "cli/process/end_by_signal.h"

#include <csignal>

#include "cli/progress_bar.h"
#include "io/output/temporary_file.h"

namespace resect {
namespace {

// Whether the signal, left alone, ends a program.
bool ends(int signal) {
  switch (signal) {
    case SIGKILL:
    case SIGSTOP:
    case SIGTSTP:
    case SIGTTIN:
    case SIGTTOU:
    case SIGCONT:
    case SIGCHLD:
    case SIGURG:
    case SIGWINCH:
      return false;
    default:
      return true;
  }
}

// The signal is held back until the handler returns; it then meets the default, and ends the
// program.
void cleanUp(int signal) {
  removeTemporaryFiles();
  wipeProgressBar();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void cleanUpOnSignals() {
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction now {};
    if (!ends(signal) || ::sigaction(signal, nullptr, &now) != 0) continue;
    if ((now.sa_flags & SA_SIGINFO) || now.sa_handler != SIG_DFL) continue;  // ignored, or taken
    struct sigaction wanted {};
    wanted.sa_handler = cleanUp;
    ::sigemptyset(&wanted.sa_mask);
    ::sigaction(signal, &wanted, nullptr);  // fails for those of the C library itself
  }
}

}  // namespace resect
