// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "geometry/primitives.h"
#include "support/sentence.h"
#include "tools/registry.h"

using namespace resect;
using test::refuses;

namespace {

template <typename Change>
bool toolRefused(Change change, const char* what) {
  ToolModel model;
  model.name = "probe";
  model.kind = "baton";
  model.mesh = boxMesh({Vec3::Zero(), Vec3::Constant(0.01)});
  change(model);
  return refuses([&] { makeTool(model); }, what);
}

}  // namespace

TEST_CASE("a tool without a shape, of no known kind or with numbers that are none is refused") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(toolRefused([](ToolModel& m) { m.mesh = {}; }, "has no shape"));
  CHECK(toolRefused([](ToolModel& m) { m.mesh.triangles[0][1] = -7; }, "uses a point"));
  CHECK(toolRefused([&](ToolModel& m) { m.mesh.points[0].x() = none; }, "not finite"));
  CHECK(toolRefused(
      [](ToolModel& m) {
        m.drawn = {{m.mesh}};
        m.drawn[0].mesh.triangles[0][1] = 99;
      },
      "a point beyond"));
  CHECK(toolRefused(
      [](ToolModel& m) {
        m.drawn = {{m.mesh}};
        m.drawn[0].normals.resize(3);
      },
      "3 normals"));
  CHECK(toolRefused([](ToolModel& m) { m.kind = "spoon"; }, "no kind of tool \"spoon\""));
  CHECK(toolRefused([](ToolModel& m) { m.parts = {"drill"}; }, "no working part \"drill\""));
  CHECK(toolRefused([&](ToolModel& m) { m.edge = {Vec3::Constant(none)}; }, "\"probe\""));
  CHECK(toolRefused([&](ToolModel& m) { m.hook = {Vec3::Constant(none)}; }, "\"probe\""));
  CHECK(toolRefused([&](ToolModel& m) { m.tip.x() = none; }, "\"probe\""));
  CHECK(toolRefused([&](ToolModel& m) { m.jaws.opening = none; }, "\"probe\""));
  CHECK(toolRefused([](ToolModel& m) { m.friction = -1; }, "\"probe\""));
  CHECK(toolRefused([&](ToolModel& m) { m.slipForce = none; }, "\"probe\""));
}
