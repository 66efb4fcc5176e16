#include "base/stop.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/parallel.h"
#include "base/progress.h"

using namespace resect;

TEST_CASE("a loop on any number of threads stops by the flag of the thread that began it") {
  for (const int threads : {1, 2, 3}) {
    CAPTURE(threads);
    const ThreadLimit limit(threads);
    std::atomic<bool> flag = false;
    std::atomic<int> blocks = 0;
    const StopBy stop(flag);
    const auto loop = [&](int stopAt) {
      parallelFor(100'000, 1, [&](std::size_t, std::size_t) {
        if (++blocks == stopAt) flag = true;
      });
    };
    loop(-1);
    CHECK(blocks == 100'000);
    blocks = 0;
    CHECK_THROWS_AS(loop(10), Cancelled);
    CHECK(blocks < 100'000);
    CHECK_THROWS_AS(checkStop(), Cancelled);
  }
}

TEST_CASE("work without a flag, or with one that is not set, is never stopped") {
  std::atomic<bool> outer = true, inner = false;
  checkStop();
  CHECK(stopFlag() == nullptr);
  {
    const StopBy stop(outer);
    CHECK_THROWS_AS(checkStop(), Cancelled);
    {
      const StopBy within(inner);
      checkStop();
    }
    CHECK_THROWS_AS(checkStop(), Cancelled);
  }
  checkStop();
}
