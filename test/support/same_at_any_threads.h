// Checks that work gives the same result at 1, 2 and 3 threads and when repeated.
#pragma once

#include <doctest/doctest.h>

#include "base/parallel.h"

namespace resect::test {

// run(threads) gives a digest of what came out; it may use parallelFor.
template <typename Run>
void checkSameAtAnyThreads(Run run) {
  const auto limited = [&](int threads) {
    const ThreadLimit limit(threads);
    return run(threads);
  };
  const std::uint64_t first = limited(1);
  for (const int threads : {1, 2, 3}) CHECK(first == limited(threads));
}

}  // namespace resect::test
