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
bool answered = false;  // whether the work has noticed Ctrl-C

void interrupt(int) { interrupted = 1; }

// Catches Ctrl-C during its lifetime, unless the program was started ignoring it, and erases the
// bar if work ends early. Bars can be nested. A Ctrl-C that the work did not notice ends the
// program when the outermost bar is destroyed.
struct Bar {
  Bar() {
    struct sigaction now {};
    ::sigaction(SIGINT, nullptr, &now);
    before = now.sa_handler;
    if (before != interrupt) {
      interrupted = 0;
      answered = false;
    }
    if (before != SIG_IGN) std::signal(SIGINT, interrupt);
  }
  ~Bar() {
    wipe();
    if (before == SIG_IGN) return;
    std::signal(SIGINT, before);
    if (interrupted && !answered && before != interrupt) std::raise(SIGINT);
  }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;
  void wipe() {
    if (shown) std::fputs("\r\033[K", stderr);
    shown = false;
  }
  void (*before)(int);
  bool shown = false;
};

}  // namespace

Progress progressBar(const std::string& title) {
  using Clock = std::chrono::steady_clock;
  const auto started = Clock::now();
  const auto bar = std::make_shared<Bar>();
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  return [=](double share) {
    const double seconds = std::chrono::duration<double>(Clock::now() - started).count();
    if (share >= 1) {
      bar->wipe();
    } else if (terminal && seconds > 1) {
      const int filled = int(30 * share);
      if (share < 0)
        fmt::print(stderr, "\r{}: {:.0f} s ...", title, seconds);
      else
        fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3.0f} %", title, "", filled, "", 30 - filled,
                   100 * share);
      std::fflush(stderr);
      bar->shown = true;
    }
    if (interrupted) answered = true;
    return interrupted == 0;
  };
}

}  // namespace resect
