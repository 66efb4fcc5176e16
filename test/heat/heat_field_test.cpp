#include "heat/heat_field.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "support/references/point_heat.h"

using namespace resect;

namespace {

const auto kEverywhere = [](const Vec3&) { return true; };

// A box of 80 mm round `centre`; the lattice does not lie symmetrically in it.
HeatField field(const Vec3& centre = Vec3(0.013, -0.007, 0.021)) {
  return HeatField({centre - Vec3::Constant(0.0403), centre + Vec3::Constant(0.0397)});
}

}  // namespace

TEST_CASE("heat spreads as from the analytic point source in perfused tissue") {
  const Vec3 centre(0.0133, -0.0071, 0.0212);
  HeatField heat = field();
  const HeatSource source{centre, 0.004, 0.08};
  std::vector<Vec3> heated;  // cells: the source is a sum of points in them
  Aabb ball;
  ball.grow(centre);
  visitCellsIn(heat.lattice(), ball.padded(source.radius), [&](const Vec3i& cell) {
    const Vec3 place = heat.lattice().centre(cell);
    if ((place - centre).norm() <= source.radius) heated.push_back(place);
  });
  constexpr int kParts = 3, kPoints = kParts * kParts * kParts;  // points for each cell
  const auto riseAt = [&](const Vec3& place, double time) {
    double sum = 0;
    for (const Vec3& middle : heated)
      for (int i = 0; i < kPoints; ++i) {
        const Vec3 part(i % kParts, i / kParts % kParts, i / kParts / kParts);
        const Vec3 off = (part + Vec3::Constant(0.5)) / kParts - Vec3::Constant(0.5);
        sum += test::riseAround(0.08, (place - middle - HeatField::kSpacing * off).norm(), time);
      }
    return sum / double(kPoints * heated.size());
  };
  double time = 0;
  for (const double until : {60.0, 120.0, 500.0}) {
    for (; time < until - 1e-9; time += 0.2) heat.step({&source, 1}, 0.2, kEverywhere);
    for (const double r : {0.005, 0.0065, 0.008, 0.0095, 0.011}) {
      for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.48, 0.64)}) {
        // At a place of the lattice: between these the temperature is a chord of a convex curve.
        const Vec3 at = heat.lattice().toCellSpace(centre + r * way).array().round();
        const Vec3 place = heat.lattice().centre(at.cast<int>());
        const double expected = riseAt(place, time);
        CAPTURE(time);
        CAPTURE(place);
        const double off = heat.temperature(place) - kBodyTemperature - expected;
        // Where heat has hardly arrived, cells that are less than 0.01 K warm are not stored.
        CHECK(std::abs(off) < 0.02 * expected + 0.0015);
        if (until == 500) CHECK(std::abs(off) < 0.01 * expected);
      }
    }
  }
}

TEST_CASE("the length of the frames matters little") {
  const HeatSource source{Vec3(0.013, -0.007, 0.021), 0.003, 5};
  HeatField fine = field(), coarse = field();
  for (int i = 0; i < 240; ++i) fine.step({&source, 1}, 1.0 / 60, kEverywhere);
  for (int i = 0; i < 8; ++i) coarse.step({&source, 1}, 0.5, kEverywhere);
  for (const double r : {0.0, 0.003, 0.006})
    CHECK(coarse.temperature(source.place + Vec3(r, 0, 0)) ==
          doctest::Approx(fine.temperature(source.place + Vec3(r, 0, 0))).epsilon(0.02));
}

TEST_CASE("what is brought in is found again, as warmth and as steam") {
  const HeatSource source{Vec3(0.013, -0.007, 0.021), 0.003, 40};
  HeatField heat = field();
  for (int i = 0; i < 120; ++i) heat.step({&source, 1}, 1.0 / 60, kEverywhere);
  // Perfusion carries away up to 0.7 % in 2 s.
  CHECK(heat.energy() == doctest::Approx(80).epsilon(0.01));
  double hottest = 0, driest = 1;
  for (const HeatedSpot& s : heat.spots()) {
    hottest = std::max(hottest, s.temperature);
    driest = std::min(driest, s.water);
    CHECK((s.water == 1 || s.temperature <= 100));
  }
  CHECK(hottest == doctest::Approx(100).epsilon(1e-3));
  CHECK(driest < 0.9);
  CHECK(heat.charred(source.place) == 0);
  for (int i = 0; i < 900; ++i) heat.step({&source, 1}, 1.0 / 60, kEverywhere);
  CHECK(heat.charred(source.place) > 0.9);  // dry, and hotter than 150 C
}

TEST_CASE("pig liver is half coagulated after the time that was measured") {
  // Jacques, Newman and He 1991, by their rate constants: about half a minute at 60 C, minutes
  // at 55.
  CHECK(std::log(2) / coagulationRate(60) == doctest::Approx(31).epsilon(0.03));
  CHECK(std::log(2) / coagulationRate(55) > 120);
  CHECK(std::log(2) / coagulationRate(80) < 0.2);
  CHECK(coagulationRate(37) < 2e-5);
}

TEST_CASE("nothing flows through the tissue's surface, and spots go with the tissue") {
  HeatField heat = field();
  const Vec3 centre(0.013, -0.007, 0.021);
  const auto half = [&](const Vec3& p) { return p.x() < centre.x(); };
  const HeatSource source{centre, 0.004, 3};
  for (int i = 0; i < 300; ++i) heat.step({&source, 1}, 1.0 / 60, half);
  CHECK(heat.energy() == doctest::Approx(15).epsilon(0.02));
  for (const HeatedSpot& s : heat.spots()) {
    const Vec3 place = heat.lattice().centre(heat.lattice().cell(s.index));
    REQUIRE(half(place));
  }
  heat.keepIn([](const Vec3&) { return false; });
  CHECK(heat.empty());
}

TEST_CASE("tissue that cools keeps its damage, and is forgotten where it has none") {
  HeatField heat = field();
  const HeatSource source{Vec3(0.013, -0.007, 0.021), 0.003, 20};
  for (int i = 0; i < 120; ++i) heat.step({&source, 1}, 1.0 / 60, kEverywhere);
  const double before = heat.coagulated(source.place);
  REQUIRE(before > 0.95);
  for (int i = 0; i < 900; ++i) heat.step({}, 1, kEverywhere);
  CHECK(heat.temperature(source.place) == doctest::Approx(37).epsilon(0.01));
  CHECK(heat.coagulated(source.place) >= before);
  double least = 1;
  for (const HeatedSpot& s : heat.spots()) least = std::min(least, s.coagulated);
  CHECK(least > 0);
  CHECK(heat.coagulated(source.place + Vec3(0.02, 0, 0)) == 0);
}

TEST_CASE("at the tissue's surface the coagulated share is that of the tissue, not half of it") {
  const auto below = [](const Vec3& at) { return at.y() < -0.0071; };
  HeatField heat = field();
  for (int i = 0; i < 600; ++i)
    heat.step(std::array{HeatSource{Vec3(0.0133, -0.0071, 0.0212), 0.006, 20}}, 1.0 / 60, below);
  const Vec3 deep(0.0133, -0.0101, 0.0212), surface(0.0133, -0.0071, 0.0212);
  CHECK(heat.coagulated(deep) > 0.99);
  CHECK(heat.coagulatedTissue(surface, below) > 0.99);
  CHECK(heat.coagulated(surface) < 0.8);
  CHECK(heat.coagulatedTissue(surface + Vec3(0.03, 0, 0), below) == 0);  // cold
}
