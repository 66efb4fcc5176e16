// Reports to scripts on standard output: one line per event, flushed at once.
#pragma once

#include <fmt/format.h>

#include <cstdio>

namespace resect {

template <typename... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  fmt::print(format, std::forward<Args>(args)...);
  std::fputc('\n', stdout);
  std::fflush(stdout);
}

}  // namespace resect
