// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "sph/colour_field.h"
#include "sph/particle_sums.h"
#include "support/block_organ.h"
#include "support/sentence.h"

using namespace resect;
using test::refuses;

namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("a field of cells that do not fit their lattice, or of no known refinement, is refused") {
  const Discretization right = test::fullBlock({4, 3, 2});
  for (const int refine : {-1, 0, 5})
    CHECK(refuses([&] { ColourField(right, refine); }, "surface nodes per cell"));
  Discretization fewer = right;
  fewer.lattice.dims.x() = 5;
  CHECK(refuses([&] { ColourField(fewer, 2); }, "24 colour values"));
  Discretization huge = right;
  huge.lattice.dims = Vec3i::Constant(2'000'000'000);
  CHECK(refuses([&] { ColourField(huge, 2); }, "a lattice of"));
  for (const double wrong : {0.0, -0.005, kNaN, std::numeric_limits<double>::infinity()}) {
    Discretization odd = right;
    odd.lattice.spacing.y() = wrong;
    CHECK(refuses([&] { ColourField(odd, 2); }, "lattice"));
    CHECK(refuses([&] { requireSound(odd); }, "lengths above 0"));
  }
  Discretization unmarked = right;
  unmarked.inside.pop_back();
  CHECK(refuses([&] { requireSound(unmarked); }, "23 flags"));
  unmarked = right;
  unmarked.label.assign(3, 0);
  CHECK(refuses([&] { requireSound(unmarked); }, "3 labels"));
  for (const int wrong : {-1, 256})
    CHECK(refuses([&] { unmarked.nameLabel(wrong, "x"); }, "label"));
}

TEST_CASE("an iso level through solid tissue is refused") {
  for (const float wrong : {0.f, 99.f, -50.f, std::numeric_limits<float>::quiet_NaN()})
    CHECK(refuses([&] { requireIso(wrong); }, "iso level"));
}

TEST_CASE("sums over particles that do not fit their attributes are refused") {
  const std::vector<Vec3> places = {Vec3::Zero(), Vec3::UnitX()}, nowhere = {Vec3::Constant(kNaN)};
  const std::vector<double> two(2, 1), one(1, 1);
  CHECK(refuses([&] { ParticleSums(places, one, 0.1); }, "2 positions and 1 volumes"));
  CHECK(refuses([&] { ParticleSums(nowhere, one, 0.1); }, "not finite"));
  for (const double wrong : {0.0, -0.1, kNaN})
    CHECK(refuses([&] { ParticleSums(places, two, wrong); }, "smoothing length"));
  const ParticleSums sums(places, two, 0.1);
  CHECK(refuses([&] { sums.interpolate(one, Vec3::Zero()); }, "1 values for 2"));
  CHECK(refuses([&] { sums.density(one, Vec3::Zero()); }, "1 masses for 2"));
}

TEST_CASE("a region that is not placed yet holds nothing that could be asked for") {
  Region region;
  region.landmark = "hilum";
  CHECK(refuses([&] { region.holds(Vec3::Zero()); }, "not yet placed"));
}
