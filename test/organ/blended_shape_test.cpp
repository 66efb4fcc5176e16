#include "organ/builtin/blended_shape.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

using namespace resect;

namespace {

BlendedEllipsoid ball(double x, double radius, double fillet, Blend blend = Blend::Add) {
  BlendedEllipsoid e;
  e.blend = blend;
  e.centre = {x, 0, 0};
  e.radii = Vec3::Constant(radius);
  e.fillet = fillet;
  return e;
}

}  // namespace

TEST_CASE("one ball gives its exact distance") {
  const BlendedShape shape(std::array{ball(0.01, 0.03, 0.01)});
  CHECK(shape({0.01, 0.05, 0}) == doctest::Approx(0.02));
  CHECK(shape({0.01, 0, 0.03}) == doctest::Approx(0).epsilon(1e-12));
  CHECK(shape({0.02, 0, 0}) == doctest::Approx(-0.02));
}

TEST_CASE("a turned ellipsoid has its surface where it should be") {
  BlendedEllipsoid e;
  e.centre = {0.1, 0.2, 0.3};
  e.turn = {0, 0, std::sin(std::numbers::pi / 4), std::cos(std::numbers::pi / 4)};  // x to y
  e.radii = {0.05, 0.02, 0.01};
  const BlendedShape shape(std::array{e});
  CHECK(std::abs(shape({0.1, 0.25, 0.3})) < 1e-12);
  CHECK(std::abs(shape({0.12, 0.2, 0.3})) < 1e-12);
  CHECK(std::abs(shape({0.1, 0.2, 0.31})) < 1e-12);
  CHECK(shape({0.1, 0.24, 0.3}) < 0);
  CHECK(shape({0.14, 0.2, 0.3}) > 0);
}

TEST_CASE("a fillet fills the corner between two balls and nothing else") {
  const BlendedShape sharp(std::array{ball(-0.02, 0.022, 1e-6), ball(0.02, 0.022, 1e-6)});
  const BlendedShape soft(std::array{ball(-0.02, 0.022, 0.01), ball(0.02, 0.022, 0.01)});
  const Vec3 corner(0, 0.01, 0), away(-0.04, 0.005, 0);
  CHECK(sharp(corner) > 0);
  CHECK(soft(corner) < 0);
  CHECK(sharp(corner) - soft(corner) == doctest::Approx(0.01 / 6).epsilon(1e-3));
  CHECK(sharp(away) == soft(away));
}

TEST_CASE("carving takes away, and what is added later is not carved") {
  const auto body = ball(0, 0.03, 0.002), hole = ball(0, 0.01, 0.002, Blend::Carve);
  CHECK(BlendedShape(std::array{body, hole})({0, 0, 0.001}) > 0);
  CHECK(BlendedShape(std::array{hole, body})({0, 0, 0.001}) < 0);
}

TEST_CASE("a shape of nothing, and one that is only carved, is nowhere") {
  CHECK(BlendedShape({})(Vec3::Zero()) > 1);
  CHECK(BlendedShape(std::array{ball(0, 0.01, 0.01, Blend::Carve)})(Vec3(0, 0, 0.001)) > 1);
}
