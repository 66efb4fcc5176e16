// Tissue round a needle electrode: current that spreads through even tissue, heat by its square.
//
// A needle is nearly a prolate spheroid. Round one with foci at +-c on its axis, the potential is
// ln((x + 1) / (x - 1)), where x is the sum of the distances from both foci over 2 c (Smythe 1950,
// 5.28); by its gradient follows where the power goes. An eighth of space is computed: nothing
// flows through the planes of symmetry, as nothing flows through the tissue's surface.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "heat/heat_field.h"
#include "support/references/point_heat.h"

using namespace resect;

namespace {

constexpr double kRadius = 0.00075;  // m: 17 gauge
constexpr double kSide = HeatField::kSpacing;

// Share of the power per volume, 1/m^3, at p. length: of the needle along z, m.
double density(const Vec3& p, double length) {
  const double half = 0.5 * length, c = std::sqrt(half * half - kRadius * kRadius);
  const Vec3 above = p - Vec3(0, 0, c), below = p + Vec3(0, 0, c);
  const double x = (above.norm() + below.norm()) / (2 * c), surface = half / c;
  if (x < surface) return 0;
  const double potential = std::log((surface + 1) / (surface - 1));
  return (1 + above.normalized().dot(below.normalized())) /
         (4 * std::numbers::pi * c * c * c * potential * (x * x - 1) * (x * x - 1));
}

// The mean over a cube of the lattice round p.
double meanDensity(const Vec3& p, double length) {
  const int parts = p.head<2>().norm() < 3 * kSide ? 6 : 1;
  double sum = 0;
  for (int i = 0; i < parts * parts * parts; ++i) {
    const Vec3 place(i % parts, i / parts % parts, i / parts / parts);
    sum +=
        density(p + kSide * ((place + Vec3::Constant(0.5)) / parts - Vec3::Constant(0.5)), length);
  }
  return sum / (parts * parts * parts);
}

struct Needle {
  HeatField heat{{Vec3::Constant(0.5 * kSide), Vec3::Constant(0.075)}};  // an eighth of space
  std::vector<HeatSource> sources;

  Needle(double length, double power) {
    const Lattice& lattice = heat.lattice();
    for (std::int64_t i = 0; i < lattice.cellCount(); ++i) {
      const Vec3 p = lattice.centre(lattice.cell(i));
      const double share = meanDensity(p, length) * lattice.cellVolume();
      if (share > 1e-6) sources.push_back({p, 0, power * share});  // the rest is far and weak
    }
  }
  void run(int seconds) {
    for (int i = 0; i < seconds; ++i) heat.step(sources, 1, [](const Vec3&) { return true; });
  }
  double power() const {
    double sum = 0;
    for (const HeatSource& s : sources) sum += 8 * s.power;
    return sum;
  }
};

// At `distance` from the needle's surface, half way along it.
Vec3 besideNeedle(double distance) {
  const double across = kRadius + distance;
  return {0.6 * across, 0.8 * across, 0.5 * kSide};
}

}  // namespace

TEST_CASE("tissue round a needle electrode warms as the sum of its point sources") {
  Needle needle(0.03, 1);
  CHECK(needle.power() == doctest::Approx(1).epsilon(0.15));  // the rest is farther away
  needle.run(120);
  for (const double distance : {0.004, 0.008, 0.012}) {
    CAPTURE(distance);
    // At a place of the lattice.
    const Lattice& lattice = needle.heat.lattice();
    const Vec3 at = lattice.toCellSpace(besideNeedle(distance)).array().round();
    const Vec3 p = lattice.centre(at.cast<int>());
    double expected = 0;
    for (const HeatSource& s : needle.sources)
      for (int image = 0; image < 8; ++image) {
        Vec3 place = s.place;
        for (int a = 0; a < 3; ++a)
          if (image >> a & 1) place[a] = -place[a];
        // 0.42: mean distance, as 1 / r counts, of a cube's points from its middle.
        expected += test::riseAround(s.power, std::max((p - place).norm(), 0.42 * kSide), 120);
      }
    CHECK(needle.heat.temperature(p) - kBodyTemperature == doctest::Approx(expected).epsilon(0.03));
  }
}

// Haemmerich and Schutt 2011 (PMC3108076) measured 58.7 +- 2.5 C in excised pig liver, 8 mm from a
// needle with 30 W after 12 minutes. Here tissue is perfused and starts at 37 C, and the needle is
// not cooled. RESECT_LONG_TESTS: runs this; it takes 12 s a needle.
TEST_CASE("30 W for 12 minutes make it hotter beside a needle than was measured") {
  if (!std::getenv("RESECT_LONG_TESTS")) return;
  for (const double length : {0.02, 0.03}) {
    Needle needle(length, 30);
    needle.run(720);
    const double beside = needle.heat.temperature(besideNeedle(0.008));
    MESSAGE("needle of " << 1e3 * length << " mm: " << beside << " C at 8 mm");
    CHECK(beside > 58.7 + 3);
  }
}
