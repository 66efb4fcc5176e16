// RESECT_ASSERT: stops the program where our own code is wrong, with file and line. Errors of the
// outside world are `Error`s.
#pragma once

namespace resect {
[[noreturn]] void assertFailed(const char* condition, const char* file, int line);
}

#define RESECT_ASSERT(condition) \
  ((condition) ? void(0) : ::resect::assertFailed(#condition, __FILE__, __LINE__))
