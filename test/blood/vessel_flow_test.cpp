#include "blood/flow/vessel_flow.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "anatomy/small_vessels.h"

using namespace resect;

namespace {

constexpr std::uint32_t kAll = (1u << kFilaments) - 1;

struct Solved {
  VesselState state;
  std::vector<double> sinusoids{5 * kMmHg};
  double air = 0;
  double out() const {
    double sum = 0;
    for (const VesselInjury& i : state.injuries) sum += i.flow[0] + i.flow[1];
    return sum;
  }
};

// The steady state.
Solved solved(const VesselFlow& flow, VesselState state, double pressure = 0) {
  Solved result{std::move(state)};
  EndOutside outside;
  outside.pressure[0] = outside.pressure[1] = pressure;
  const std::vector<EndOutside> all(result.state.injuries.size(), outside);
  for (int i = 0; i < 60; ++i) result.air = flow.solve(result.state, all, {}, result.sinusoids);
  return result;
}

VesselState severed(std::int32_t segment, double share) {
  VesselState state;
  state.injuries.push_back({segment, kAll, share, share, 0, {0, 0}, 0});
  return state;
}

double inflow(const VesselFlow& flow) {
  return flow.inflow(VesselKind::PortalVein) + flow.inflow(VesselKind::HepaticVein) +
         flow.inflow(VesselKind::HepaticArtery);
}

}  // namespace

TEST_CASE("without injuries the organ has the flow and the pressures of its supply") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  const Solved s = solved(flow, {});
  CHECK(flow.inflow(VesselKind::PortalVein) == doctest::Approx(18.75e-6).epsilon(1e-9));
  CHECK(flow.inflow(VesselKind::HepaticArtery) == doctest::Approx(6.25e-6).epsilon(1e-9));
  CHECK(flow.inflow(VesselKind::HepaticVein) == doctest::Approx(-25e-6).epsilon(1e-9));
  CHECK(s.sinusoids[0] == doctest::Approx(5 * kMmHg).epsilon(1e-9));
}

TEST_CASE("what flows in flows out, to a billionth, whatever is cut, clipped or clamped") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  for (int segment = 0; segment < 9; ++segment)
    for (const bool clamped : {false, true})
      for (const bool clipped : {false, true}) {
        CAPTURE(segment);
        VesselState state = severed(segment, 0.4);
        state.inflowClamped = clamped;
        if (clipped) state.addClip({segment, 0.2});
        const Solved s = solved(flow, state);
        CHECK(std::abs(inflow(flow) - s.out()) < 1e-9 * 25e-6);
        if (clipped) CHECK(s.state.injuries[0].flow[0] == 0);
        CHECK(s.state.injuries[0].flow[1] >= 0);
      }
}

TEST_CASE("a thin long vessel bleeds by Poiseuille's law, a wide short one as an orifice") {
  Circulation steady;
  steady.artery.resistance = 1e3;  // a source that does not give way
  const auto bleeding = [&](double radius, double length) {
    const VesselFlow flow(
        makeVesselMap(test::straightVessel(VesselKind::HepaticArtery, Vec3::Zero(),
                                           Vec3(2 * length, 0, 0), radius)),
        steady);
    return solved(flow, severed(0, 0.5)).state.injuries[0].flow[0];
  };
  const double pressure = steady.artery.pressure;
  const double thin = bleeding(0.1e-3, 0.1);
  CHECK(thin == doctest::Approx(pressure * std::numbers::pi * 1e-16 / (8 * kBloodViscosity * 0.1))
                    .epsilon(0.01));
  const double wide = bleeding(2e-3, 0.005), area = std::numbers::pi * 4e-6;
  CHECK(wide ==
        doctest::Approx(area * std::sqrt(2 * pressure / (1.56 * kBloodDensity))).epsilon(0.02));
}

TEST_CASE("sealed ends do not bleed, and a hole in a wall bleeds less than a severed vessel") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  VesselState state = severed(1, 0.5);
  const double all = solved(flow, state).out();
  state.injuries[0].cut = 0b111111;
  const double hole = solved(flow, state).out();
  CHECK(hole > 0);
  CHECK(hole < all);
  state.injuries[0].cut = kAll;
  state.injuries[0].sealed = 3;
  CHECK(solved(flow, state).out() == 0);
}

TEST_CASE("a clip beside a hole in a wall stops it, although it has bled before") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  VesselState state = severed(1, 0.5);
  state.injuries[0].cut = 0b111111;
  Solved bleeds = solved(flow, state);
  CHECK(bleeds.out() > 0);
  bleeds.state.addClip({1, 0.4});
  CHECK(solved(flow, bleeds.state).out() == 0);
}

TEST_CASE("clamping the inflow leaves a portal branch only what runs back out of the sinusoids") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  VesselState state = severed(1, 0.5);
  const double open = solved(flow, state).out();
  state.inflowClamped = true;
  const double clamped = solved(flow, state).out();
  CHECK(clamped < 0.3 * open);
  CHECK(clamped > 0);
}

TEST_CASE("where the outside pressure is higher nothing flows, and wide hepatic veins draw air") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  const double high = 120 * kMmHg;                          // more than any source has
  const Solved vein = solved(flow, severed(3, 0.5), high);  // the stem, 6 mm
  CHECK(vein.out() == doctest::Approx(-vein.air));
  CHECK(vein.air > 0);
  CHECK(solved(flow, severed(1, 0.5), high).air == 0);  // portal
}

// The second branch of each fork leads into a piece that was cut off from the body, but for them.
static VesselState piece() {
  VesselState state;
  state.apart = {{2, 1}, {5, 1}, {8, 1}};
  return state;
}

// Severed and closed on the root's side.
static void divide(VesselState& state, std::int32_t segment) {
  state.injuries.push_back({segment, kAll, 0.5, 0.5, 1, {0, 0}, 0});
}

TEST_CASE("a piece that hangs on its vessels has its own pressure") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  const Solved whole = solved(flow, piece());
  REQUIRE(whole.sinusoids.size() == 2);
  CHECK(whole.sinusoids[0] == doctest::Approx(5 * kMmHg).epsilon(1e-9));
  CHECK(whole.sinusoids[1] == doctest::Approx(5 * kMmHg).epsilon(1e-9));
  CHECK(flow.inflow(VesselKind::PortalVein) == doctest::Approx(18.75e-6).epsilon(1e-9));

  VesselState state = piece();
  divide(state, 5);
  state.injuries[0].sealed = 3;
  const Solved congested = solved(flow, state);  // blood comes, and none leaves
  CHECK(congested.sinusoids[1] > 7 * kMmHg);
  CHECK(congested.sinusoids[0] < congested.sinusoids[1] - kMmHg);
  CHECK(std::abs(inflow(flow) - congested.out()) < 1e-9 * 25e-6);

  state = piece();
  divide(state, 2), divide(state, 8);
  const Solved backwards = solved(flow, state);  // the cava's blood comes back through it
  CHECK(backwards.sinusoids[1] < 4 * kMmHg);
  CHECK(backwards.sinusoids[1] < backwards.sinusoids[0] - kMmHg);
  CHECK(backwards.out() > 0);
  CHECK(std::abs(inflow(flow) - backwards.out()) < 1e-9 * 25e-6);
}

TEST_CASE("a piece to which no vessel leads does not bleed, and the body does") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  VesselState state = piece();
  divide(state, 2), divide(state, 5), divide(state, 8);
  const Solved apart = solved(flow, state);
  CHECK(apart.out() == 0);
  CHECK(apart.sinusoids[1] == 0);
  CHECK(apart.sinusoids[0] > 4 * kMmHg);

  state.injuries[0].sealed = 0;  // the portal vein's stump in the body
  const Solved bleeds = solved(flow, state);
  CHECK(bleeds.state.injuries[0].flow[0] > 1e-6);
  CHECK(bleeds.state.injuries[0].flow[1] == 0);

  state.apart.clear();  // as long as it is one tissue, its sinusoids feed the far ends
  CHECK(solved(flow, state).state.injuries[0].flow[1] > 0);
  state.apart = {{2, SegmentPart::kCrumb}, {5, SegmentPart::kCrumb}, {8, SegmentPart::kCrumb}};
  CHECK(solved(flow, state).state.injuries[0].flow[1] == 0);
}

TEST_CASE("where nothing flows in or out the pressure stays") {
  const VesselFlow flow(makeVesselMap(test::threeForks()), {});
  VesselState state;
  state.inflowClamped = true;
  state.addClip({3, 0.5});  // the trunk of the hepatic veins
  CHECK(solved(flow, state).sinusoids[0] == doctest::Approx(5 * kMmHg).epsilon(1e-6));
}
