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

TEST_CASE("a clip slips off a vessel that is cut beside it, which bleeds, and this is an event") {
  Simulation simulation = test::bleedingBlock();
  EventMemory memory;
  const double length = 0.07, at = (kCut.x() + 0.02) / length;
  step(simulation,
       {{0, 0, PlaceClip{0, at - 0.001 / length}}, {0, 0, PlaceClip{0, at + 0.004 / length}}});
  CHECK(simulation.organ().vessels.clips.size() == 2);
  StepReport report = step(simulation, {{0, -1, Incision{test::acrossX(kCut.x(), 0.01, 0.05)}}});
  CHECK(simulation.organ().vessels.clips.size() == 1);
  std::vector<OperationEvent> slips;
  for (const OperationEvent& event : eventsOf(report, simulation, memory))
    if (event.kind == "clip_slips") slips.push_back(event);
  REQUIRE(slips.size() == 1);
  CHECK(slips[0].text.ends_with("of 4.0 mm"));
  for (int i = 0; i < 10; ++i) report = step(simulation);
  CHECK(report.slipped.empty());
  CHECK(report.blood.rate > 0);
}

TEST_CASE("air that an open hepatic vein draws in is an event that ends, and its volume is kept") {
  // The vein lies 20 cm above the beginning of the portal vein.
  const double low = kCut.y() - 0.2;
  Simulation simulation = test::bleedingBlock(makeAnatomy(
      {{VesselKind::PortalVein, -1, Vec3(0, low, 0), Vec3(0, low + 0.01, 0), 0.002, true},
       {VesselKind::HepaticVein, -1, Vec3(-0.02, kCut.y(), kCut.z()),
        Vec3(0.05, kCut.y(), kCut.z()), 0.002, true}}));
  EventMemory memory;
  std::vector<std::string> kinds;
  const auto run = [&](std::vector<TissueEdit> edits) {
    const StepReport report = step(simulation, std::move(edits));
    for (const OperationEvent& event : eventsOf(report, simulation, memory))
      if (event.kind.starts_with("air")) kinds.push_back(event.kind);
    return report;
  };
  run({{0, -1, Incision{test::acrossX(kCut.x(), 0.01, 0.05)}}});
  StepReport report;
  for (int i = 0; i < 30; ++i) report = run({});
  CHECK(report.blood.airRate > 0);
  // 20 cm of blood less the 3 mmHg of the vena cava, through the lumen of 4 mm.
  const double pressure = kBloodDensity * kEarth * 0.2 - 3 * kMmHg;
  const double area = 3.14159 * 0.002 * 0.002;
  CHECK(report.blood.airRate <= 1.01 * area * std::sqrt(2 * pressure / (1.56 * kBloodDensity)));
  CHECK(simulation.blood().air() > 0);
  CHECK(report.blood.rate < 1e-8);
  run({{0, 0, PlaceClip{1, 0.2}}, {0, 0, PlaceClip{1, 0.9}}});
  for (int i = 0; i < 3; ++i) report = run({});
  CHECK(report.blood.airRate == 0);
  CHECK(kinds == std::vector<std::string>{"air", "air_stops"});
}
