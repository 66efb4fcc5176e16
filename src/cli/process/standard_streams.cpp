#include "cli/process/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "io/output/output_target.h"

namespace resect {

void openStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);  // gets the lowest free number
}

void finishStandardOutput() {
  const bool failedBefore = std::ferror(stdout) != 0;
  errno = 0;
  // Closing, too, reports faults, of file systems that write late.
  if (std::fclose(stdout) == 0 && !failedBefore) return;
  throw error("cannot write to standard output{}; what was printed is not complete",
              errno == 0 ? "" : fmt::format(": {}", std::strerror(errno)));
}

std::FILE* placeForText(std::initializer_list<std::filesystem::path> outputs) {
  const bool taken = std::ranges::any_of(
      outputs, [](const std::filesystem::path& output) { return isStandardOutput(output); });
  return taken ? stderr : stdout;
}

}  // namespace resect
