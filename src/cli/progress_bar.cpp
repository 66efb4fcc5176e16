#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>

#include "base/text/shown_text.h"

namespace resect {
namespace {

std::atomic<bool> shown{false};

// Erases the bar if work ends early.
struct Bar {
  Bar() = default;
  ~Bar() { wipeProgressBar(); }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;
};

}  // namespace

Progress progressBar(const std::string& name) {
  const std::string title = shownText(name);
  using Clock = std::chrono::steady_clock;
  const auto started = Clock::now();
  const auto bar = std::make_shared<Bar>();
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  return [=](double share) {
    const double seconds = std::chrono::duration<double>(Clock::now() - started).count();
    if (share >= 1) {
      wipeProgressBar();
    } else if (terminal && seconds > 1) {
      const int filled = int(30 * share);
      shown = true;
      if (share < 0)
        fmt::print(stderr, "\r{}: {:.0f} s ...", title, seconds);
      else
        fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3.0f} %", title, "", filled, "", 30 - filled,
                   100 * share);
      std::fflush(stderr);
    }
    return true;
  };
}

void wipeProgressBar() noexcept {
  constexpr char kWipe[] = "\r\033[K";
  const int fault = errno;
  // Nothing depends on whether the terminal takes it.
  if (shown.exchange(false) && ::write(STDERR_FILENO, kWipe, sizeof kWipe - 1) < 0) errno = fault;
}

}  // namespace resect
