#include <doctest/doctest.h>

#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/stage_clock.h"
#include "base/state/state_hash.h"

using namespace resect;

TEST_CASE("the state hash sees every bit and the order") {
  StateHash a, b, c;
  a.add(1.0);
  a.add(2.0);
  b.add(2.0);
  b.add(1.0);
  c.add(1.0);
  c.add(2.0000000000000004);
  CHECK(a.value() != b.value());
  CHECK(a.value() != c.value());
  StateHash zero, minusZero;
  zero.add(0.0);
  minusZero.add(-0.0);
  CHECK(zero.value() != minusZero.value());
  CHECK(a.hex().size() == 16);
}

TEST_CASE("parallelFor visits every index once at any number of threads") {
  for (int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    for (std::size_t count : {0u, 1u, 7u, 1000u}) {
      std::vector<int> visits(count, 0);
      parallelFor(count, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (int n : visits) REQUIRE(n == 1);
    }
  }
}

TEST_CASE("an exception in a parallel body reaches the caller") {
  for (const int threads : {0, 1, 2}) {
    const ThreadLimit limit(threads);
    CHECK_THROWS_AS(parallelFor(100, 1, [](std::size_t, std::size_t) { throw error("no"); }),
                    Error);
  }
}

TEST_CASE("a thread limit inside another can only lower it, and ends with its life") {
  const ThreadLimit outer(2);
  CHECK(threadsAllowed() == 2);
  {
    const ThreadLimit lower(1);
    CHECK(threadsAllowed() == 1);
    const ThreadLimit higher(3);
    CHECK(threadsAllowed() == 1);
  }
  CHECK(threadsAllowed() == 2);
}

TEST_CASE("the random generator gives the published numbers of splitmix64") {
  Random random(1234567);
  CHECK(random.next() == 6457827717110365317u);
  CHECK(random.next() == 3203168211198807973u);
  for (int i = 0; i < 1000; ++i) {
    const double u = random.uniform();
    REQUIRE(u >= 0);
    REQUIRE(u < 1);
  }
}

TEST_CASE("a time summary of known values is exact") {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  const TimeSummary s = summarise(values);
  CHECK(s.max == 100);
  CHECK(s.total == 5050);
  CHECK(s.median == 51);
  CHECK(s.p95 == 95);
  CHECK(summarise({}).max == 0);
}

TEST_CASE("a usage error asks for exit status 2") {
  CHECK(int(usageError("bad {}", 1).status()) == 2);
  CHECK(int(error("bad").status()) == 1);
}
