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

TEST_CASE("tissue that boils smokes: where, by which instrument, and as an event that ends") {
  Simulation simulation = test::bleedingBlock();
  EventMemory memory;
  std::vector<std::string> kinds;
  const auto run = [&](std::vector<TissueEdit> edits) {
    const StepReport report = step(simulation, std::move(edits));
    for (const OperationEvent& event : eventsOf(report, simulation, memory))
      if (event.kind.starts_with("smoke")) kinds.push_back(event.kind);
    return report;
  };
  CHECK(run({}).smoke.empty());
  CHECK(run({{0, 0, Heat{kCut, 0.004, 1}}}).smoke.empty());  // warm is no smoke
  StepReport report;
  for (int i = 0; i < 120; ++i) report = run({{0, 0, Heat{kCut, 0.004, 60}}});
  REQUIRE(report.smoke.size() == 1);
  CHECK(report.smoke[0].tool == 0);
  CHECK((report.smoke[0].place - kCut).norm() < 0.006);
  // No more than the power could boil: 60 W over 2.26 MJ/kg.
  CHECK(report.smoke[0].rate > 0);
  CHECK(report.smoke[0].rate < 1.2 * 60 / 2.26e6);
  for (int i = 0; i < 30; ++i) report = run({});
  CHECK(report.smoke.empty());
  CHECK(kinds == std::vector<std::string>{"smoke", "smoke_clears"});
}
