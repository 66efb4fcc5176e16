#include "operation/blood/bleeding_ends.h"

#include <doctest/doctest.h>

#include "operation/blood/bleeding_block.h"
#include "operation/live/operation_events.h"

using namespace resect;
using test::kCut, test::step;

TEST_CASE("the ends that bleed are those of the report, at the vessel's end, after a restore too") {
  Simulation simulation = test::bleedingBlock(), other = test::bleedingBlock();
  CHECK(bleedingEnds(simulation).empty());
  step(simulation, {{0, -1, Incision{test::acrossX(kCut.x(), 0.01, 0.05)}}});
  StepReport report;
  for (int i = 0; i < 10; ++i) report = step(simulation);
  const std::vector<BleedingEnd> ends = bleedingEnds(simulation);
  REQUIRE(ends.size() == report.blood.ends.size());
  REQUIRE(ends.size() == 1);
  CHECK(ends[0].segment == report.blood.ends[0].segment);
  CHECK(ends[0].flow == report.blood.ends[0].flow);
  CHECK((ends[0].place - kCut).norm() < 1e-6);
  other.restore(simulation.save());
  REQUIRE(bleedingEnds(other).size() == 1);
  CHECK(bleedingEnds(other)[0].flow == ends[0].flow);
}

TEST_CASE("heat and clips are work on an organ, without any contact; taking blood is none") {
  Simulation simulation = test::bleedingBlock();
  const auto works = [&](TissueEdit edit) {
    return worksOnOrgan(step(simulation, {std::move(edit)}), simulation, 0);
  };
  CHECK_FALSE(worksOnOrgan(step(simulation), simulation, 0));
  CHECK(works({0, 0, Heat{kCut, 0.003, 10}}));
  CHECK(works({0, 0, PlaceClip{0, 0.3}}));
  CHECK(works({0, 0, Incision{test::acrossX(0.01, 0.02, 0.05)}}));
  CHECK_FALSE(works({0, -1, Heat{kCut, 0.003, 10}}));
  CHECK_FALSE(works({0, 0, Suction{kCut, 0.01, 1e-6}}));
  CHECK_FALSE(works({0, 0, Press{kCut, 0.01, 100, 1e-6}}));
  CHECK_FALSE(works({0, 0, Release{}}));
}
