// Sizes of tests that the environment may change.
#pragma once

#include <cstdlib>

namespace resect::test {

// The number in an environment variable, or `otherwise`.
inline double numberFrom(const char* variable, double otherwise) {
  const char* given = std::getenv(variable);
  return given && *given ? std::atof(given) : otherwise;
}

}  // namespace resect::test
