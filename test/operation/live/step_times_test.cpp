#include "operation/live/step_times.h"

#include <doctest/doctest.h>

using namespace resect;

namespace {

// A step of two stages; that they take no time at all cannot be told from here.
StageClock twoStages() {
  StageClock clock;
  clock.start();
  clock.lap("moveTools");
  clock.lap("measure");
  return clock;
}

}  // namespace

TEST_CASE("before the first step there are no times, and the operation keeps real time") {
  const StepTimes times = LastSecond(60).times();
  CHECK(times.stages.empty());
  CHECK(times.median == 0);
  CHECK(times.realTimeFactor == 1);
}

TEST_CASE("the real-time factor is simulated over elapsed time, of the last second's steps alone") {
  LastSecond last(10);
  double now = 100;
  last.add(twoStages(), now);
  CHECK(last.times().realTimeFactor == 1);  // of one step nothing can be said
  for (int i = 0; i < 30; ++i) last.add(twoStages(), now += 0.1);
  CHECK(last.times().realTimeFactor == doctest::Approx(1));
  for (int i = 0; i < 9; ++i) last.add(twoStages(), now += 0.4);
  CHECK(last.times().realTimeFactor == doctest::Approx(0.25));
  last.add(twoStages(), now += 0.4);
  CHECK(last.times().realTimeFactor == doctest::Approx(0.25));
}

TEST_CASE("stages keep their names and order, and a step takes what its stages take") {
  LastSecond last(10);
  double longest = 0;
  for (int i = 0; i < 5; ++i) {
    const StageClock clock = twoStages();
    longest = std::max(longest, clock.stages()[0].seconds[0] + clock.stages()[1].seconds[0]);
    last.add(clock, i);
  }
  const StepTimes times = last.times();
  REQUIRE(times.stages.size() == 2);
  CHECK(times.stages[0].name == "moveTools");
  CHECK(times.stages[1].name == "measure");
  CHECK(times.worst == doctest::Approx(longest));
  CHECK(times.median <= times.worst);
}

TEST_CASE("a stage that is lapped twice in a step takes the sum") {
  StageClock clock;
  clock.start();
  clock.lap("moveTissue");
  clock.lap("moveTissue");
  LastSecond last(10);
  last.add(clock, 0);
  const auto& laps = clock.stages()[0].seconds;
  REQUIRE(laps.size() == 2);
  CHECK(last.times().stages[0].median == doctest::Approx(laps[0] + laps[1]));
}
