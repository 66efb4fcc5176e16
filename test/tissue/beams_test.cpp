// Bending of beams against beam theory.
//
// No wall is modelled: a beam of 2 L is pushed down at both ends and held up at its middle, which
// by symmetry neither turns nor warps: each half is a cantilever of length L from the middle column
// of cells to the last, and where a wall stands is not a question.
#include <doctest/doctest.h>

#include <numbers>

#include "support/beams.h"
#include "support/figures.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::material;
using test::solidBlock;

namespace {

constexpr double kBeamSpacing = 0.005;

struct Tip {
  double deflection, shortening;  // m
};

// Half a beam of `length` cells and height x height cells under a force at its tip, at rest.
Tip bend(int length, int height, const TissueMaterial& m, double force, double stepShare = 0.5) {
  TissueSettings settings = test::weightless();
  settings.stepShare = stepShare;
  ElasticTissue tissue(solidBlock({2 * length + 1, height, height}, kBeamSpacing, m), settings);
  const double share = force / (height * height);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == length) tissue.setLoad(c, {0, 2 * share, 0});
    if (at.x() == 0 || at.x() == 2 * length) tissue.setLoad(c, {0, -share, 0});
  });
  CHECK(test::relax(tissue) < 40000);
  Vec3 middle = Vec3::Zero(), left = Vec3::Zero(), right = Vec3::Zero();
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    const Vec3 u = tissue.displacement(c) / (height * height);
    if (at.x() == length) middle += u;
    if (at.x() == 0) left += u;
    if (at.x() == 2 * length) right += u;
  });
  return {middle.y() - 0.5 * (left.y() + right.y()), 0.5 * (left.x() - right.x())};
}

test::BeamSection section(int height, const TissueMaterial& m) {
  return {height * kBeamSpacing, height * kBeamSpacing, m.young, m.poisson};
}

// Force that would bend the tip by a share of the length.
double smallForce(const test::BeamSection& b, double length) {
  return 0.005 * length / test::timoshenkoTip(b, length, 1);
}

}  // namespace

TEST_CASE("a cantilever of 4 or 8 cells through its height sags as Timoshenko's does") {
  test::Figures figures("cantilever");
  for (const auto& [height, allowed] : {std::pair{4, 0.015}, std::pair{8, 0.01}}) {
    const TissueMaterial m = material(5000, 0.3);
    const test::BeamSection b = section(height, m);
    const int length = 8 * height;
    const double force = smallForce(b, length * kBeamSpacing);
    const double expected = test::timoshenkoTip(b, length * kBeamSpacing, force);
    const double measured = bend(length, height, m, force).deflection;
    CHECK(figures.add("tip at " + std::to_string(height) + " cells (m)", measured, expected,
                      allowed) < allowed);
  }
}

TEST_CASE("a beam that hardly changes volume, nu = 0.49, does not lock") {
  test::Figures figures("nearly incompressible beam");
  const TissueMaterial m = material(5000, 0.49);
  const test::BeamSection b = section(4, m);
  const double force = smallForce(b, 32 * kBeamSpacing);
  const double expected = test::timoshenkoTip(b, 32 * kBeamSpacing, force);
  CHECK(figures.add("tip at 4 cells (m)", bend(32, 4, m, force).deflection, expected, 0.015) <
        0.015);
}

TEST_CASE("a beam bent far follows the elastica") {
  test::Figures figures("elastica");
  const TissueMaterial m = material(5000, 0.3);
  const test::BeamSection b = section(4, m);
  const double length = 40 * kBeamSpacing;
  for (const double load : {0.5, 1.0, 2.0, 3.0}) {
    const double force = load * b.bending() / (length * length);
    const Tip tip = bend(40, 4, m, force);
    const test::ElasticaTip expected = test::elastica(load);
    // The elastica knows no shear; its deflection is added, as for the small one.
    const double shear = force * length / b.shearing();
    const std::string at = " at P L^2 / (E I) = " + std::to_string(load).substr(0, 3);
    CHECK(figures.add("deflection / L" + at, (tip.deflection - shear) / length, expected.deflection,
                      0.035) < 0.035);
    figures.add("shortening / L" + at, tip.shortening / length, expected.shortening, 0.035);
  }
}

TEST_CASE("a static answer does not depend on the substep") {
  test::Figures figures("substep");
  const TissueMaterial m = material(5000, 0.3);
  const test::BeamSection b = section(4, m);
  const double force = 20 * smallForce(b, 20 * kBeamSpacing);
  const double whole = bend(20, 4, m, force).deflection;
  const double quarter = bend(20, 4, m, force, 0.15).deflection;
  CHECK(figures.add("tip at dt (m), against 0.3 dt", whole, quarter, 0.005) < 0.005);
}

TEST_CASE("a free beam rings at the frequency of Timoshenko's") {
  test::Figures figures("frequency");
  const TissueMaterial m = material(5000, 0.3);
  const int cells = 60, height = 4;
  const double length = cells * kBeamSpacing;
  TissueSettings settings = test::weightless();
  settings.damping = 0.02;
  ElasticTissue tissue(solidBlock({cells, height, height}, kBeamSpacing, m), settings);
  const double expected = test::freeBeamFrequency(section(height, m), length, m.density);
  // The mode's shape, near enough: the tone is read from its projection.
  const auto shape = [&](int x) {
    return std::sin(std::numbers::pi * (x + 0.5) / cells) - 2 / std::numbers::pi;
  };
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.setVelocity(c, {0, 0.02 * shape(at.x()), 0});
  });
  const auto projection = [&] {
    double sum = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      sum += shape(at.x()) * tissue.displacement(c).y();
    });
    return sum;
  };
  const double dt = 0.999 * 2 * tissue.longestSubstep();
  std::vector<double> crossings;
  double before = 0;
  for (double time = dt; crossings.size() < 4 && time < 10 / expected; time += dt) {
    tissue.advance(dt);
    const double now = projection();
    if (before * now < 0) crossings.push_back(time - dt * now / (now - before));
    before = now;
  }
  REQUIRE(crossings.size() == 4);
  const double measured = 1.0 / (crossings[3] - crossings[1]);
  CHECK(figures.add("first frequency (1/s)", measured, expected, 0.02) < 0.02);
}
