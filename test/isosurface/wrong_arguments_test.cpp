// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "isosurface/polygonise.h"
#include "support/sentence.h"

using namespace resect;
using test::refuses;

TEST_CASE("a surface of triangles without size, or in an endless box, is refused") {
  const Aabb box{-Vec3::Ones(), Vec3::Ones()};
  const auto ball = [](const Vec3& p) { return p.norm() - 0.5; };
  for (const double wrong : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()})
    CHECK(refuses([&] { polygonise(ball, box, {.edge = wrong}); }, "longest edge"));
  CHECK(refuses([&] { polygonise(ball, box, {.edge = 0.2, .lipschitz = 0}); }, "greatest slope"));
  const Aabb endless{-Vec3::Ones(), Vec3::Constant(std::numeric_limits<double>::infinity())};
  CHECK(refuses([&] { polygonise(ball, endless, {.edge = 0.2}); }, "endless"));
  CHECK(polygonise(ball, {}, {.edge = 0.2}).triangles.empty());
}
