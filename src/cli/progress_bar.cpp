#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>

namespace resect {
namespace {

volatile std::sig_atomic_t interrupted = 0;

// Catches Ctrl-C while it lives.
struct InterruptGuard {
  InterruptGuard() : before(std::signal(SIGINT, [](int) { interrupted = 1; })) { interrupted = 0; }
  ~InterruptGuard() { std::signal(SIGINT, before); }
  void (*before)(int);
};

}  // namespace

Progress progressBar(const std::string& title) {
  using Clock = std::chrono::steady_clock;
  const auto started = Clock::now();
  const auto guard = std::make_shared<InterruptGuard>();
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  return [=, shown = false](double share) mutable {
    if (!terminal) return interrupted == 0;
    if (share >= 1) {
      if (shown) std::fputs("\r\033[K", stderr);
      shown = false;
    } else if (Clock::now() - started > std::chrono::seconds(1)) {
      const int filled = int(30 * share);
      fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3.0f} %", title, "", filled, "", 30 - filled,
                 100 * share);
      std::fflush(stderr);
      shown = true;
    }
    return interrupted == 0;
  };
}

}  // namespace resect
