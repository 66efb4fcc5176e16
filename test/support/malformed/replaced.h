// Text with one place changed, for readers of it.
#pragma once

#include <doctest/doctest.h>

#include <string>

namespace resect::test {

// With `to` where `from` first was; there must be one.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace resect::test
