#include "tools/contacts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "base/error.h"
#include "collision/inside.h"
#include "support/block_organ.h"
#include "support/test_tools.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

Pose at(const Vec3& p, double degrees = 0, const Vec3& axis = Vec3::UnitY()) {
  return {p, Eigen::Quaterniond(
                 Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()))};
}

StillTissue still(const Organ& organ) { return {organ.rest.lattice, organ.alive}; }

// All particles, each asked for by itself.
std::vector<std::int64_t> allTouched(const Organ& organ, const Tool& tool, const Pose& from,
                                     const Pose& to) {
  std::vector<std::int64_t> cells;
  std::vector<Vec3> centres;
  for (std::int64_t i = 0; i < organ.rest.lattice.cellCount(); ++i)
    if (organ.alive[i]) {
      cells.push_back(i);
      centres.push_back(organ.rest.lattice.centre(organ.rest.lattice.cell(i)));
    }
  const auto flags = sweptInside(tool.model.mesh, from, to, centres);
  std::vector<std::int64_t> touched;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (flags[i]) touched.push_back(cells[i]);
  return touched;
}

}  // namespace

TEST_CASE("clipping rows of cells against the tool's box loses no contact, whatever the motion") {
  const Organ organ = makeOrgan(test::ball(22), {});
  const Vec3 middle = organ.rest.lattice.box().centre();
  const auto tool = test::boxTool({{-0.0004, -0.01, 0}, {0.0004, 0.004, 0.12}});
  Random random(21);
  const auto anywhere = [&] {
    return Vec3(random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06),
                random.uniform(-0.06, 0.06));
  };
  int touched = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose from = at(middle + anywhere(), random.uniform(-180, 180), anywhere());
    Pose to = at(middle + anywhere(), random.uniform(-180, 180), anywhere());
    if (i % 3 == 0) to.rotation = from.rotation;
    if (i % 3 == 1) to.rotation = from.rotation * at({}, 20, anywhere()).rotation;
    const auto contacts = findContacts(organ, still(organ), *tool, from, to);
    REQUIRE(contacts.cells == allTouched(organ, *tool, from, to));
    touched += !contacts.cells.empty();
  }
  CHECK(touched > 20);
}

TEST_CASE("a thin blade that jumps across the organ in one frame touches all on its way") {
  const Organ organ = makeOrgan(test::fullBlock({20, 10, 10}), {});
  const Aabb box = organ.rest.lattice.box();
  // A wall 0.2 mm thick, as high and deep as the organ, pushed through along x from far left to far
  // right.
  const auto blade = test::boxTool({{-1e-4, -0.1, -0.1}, {1e-4, 0.1, 0.1}});
  const auto contacts = findContacts(organ, still(organ), *blade, at(box.centre() - Vec3(1, 0, 0)),
                                     at(box.centre() + Vec3(1, 0, 0)));
  CHECK(std::int64_t(contacts.cells.size()) == organ.particles);
  CHECK(std::is_sorted(contacts.cells.begin(), contacts.cells.end()));
}

TEST_CASE("a tool away from the organ touches nothing and has no volume of interest") {
  const Organ organ = makeOrgan(test::ball(12), {});
  const auto tool = test::ballTool(0.01);
  const auto contacts = findContacts(organ, still(organ), *tool, at({1, 1, 1}), at({1, 1, 1.1}));
  CHECK(contacts.cells.empty());
  CHECK(contacts.volumeOfInterest.empty());
}

TEST_CASE(
    "every kind of tool can be made, and a kind that is not there is refused with the list of "
    "those that are") {
  for (const ToolKind& kind : toolKinds()) {
    ToolModel model;
    model.kind = kind.name;
    model.mesh = boxMesh({{0, 0, 0}, {1, 1, 1}});
    CHECK(makeTool(model)->model.kind == kind.name);
  }
  ToolModel spoon;
  spoon.kind = "spoon";
  try {
    makeTool(spoon);
    FAIL("a spoon was made");
  } catch (const Error& e) {
    CHECK(std::string(e.what()).find("scalpel, hook, baton") != std::string::npos);
  }
}

TEST_CASE("a tool queues the removal of what it touches and changes nothing itself") {
  const Organ organ = makeOrgan(test::ball(8), {});
  const StillTissue tissue = still(organ);
  const auto tool = test::ballTool(0.01);
  ToolContacts contacts;
  contacts.cells = {5, 9};
  const ToolWay way;
  std::vector<TissueEdit> edits;
  REQUIRE(tool->parts.size() == 1);
  tool->parts[0]->act({tool->model, way, 0.02, 2, 1, organ, tissue, contacts}, edits);
  REQUIRE(edits.size() == 2);
  CHECK(std::get<RemoveCell>(edits[1].what).cell == 9);
  CHECK(edits[1].tool == 2);
  CHECK(edits[1].organ == 1);
}

TEST_CASE("a description may name working parts; one that there is not is refused with the list") {
  ToolModel model;
  model.name = "two in one";
  model.kind = "baton";
  model.mesh = boxMesh({{0, 0, 0}, {1, 1, 1}});
  CHECK(makeTool(model)->parts.empty());
  model.parts = {"blade", "hook"};
  CHECK(makeTool(model)->parts.size() == 2);
  model.parts = {"spoon"};
  CHECK_THROWS_WITH(makeTool(model),
                    "there is no working part \"spoon\" (tool \"two in one\"); use one of: blade, "
                    "jaws, hook, remover, suction, clip, bipolar, "
                    "gauze, inflow_clamp, pencil, aspirator, grasp");
}

TEST_CASE("the overlap is the tool's volume while it is inside, a half of it when half is") {
  const Organ organ = makeOrgan(test::ball(22), {});
  const Aabb box = organ.rest.lattice.box();
  const Aabb body{{-0.004, -0.006, -0.005}, {0.004, 0.006, 0.005}};
  const auto tool = test::boxTool(body);
  const double whole = body.size().prod();
  const Pose inside = at(box.centre(), 37, {1, 2, 3});
  const auto overlapAt = [&](const Pose& pose) {
    return findContacts(organ, still(organ), *tool, pose, pose).overlapVolume;
  };
  CHECK(overlapAt(inside) == doctest::Approx(whole).epsilon(0.02));
  CHECK(overlapAt(at(box.centre() + Vec3(0.5, 0, 0))) == 0);
  // On the ball's rim the share inside is what the surface cuts off, here measured by points.
  const TriangleMesh surface = organ.surface.mesh();
  const Vec3 rim(bounds(surface).max.x() - 0.001, box.centre().y(), box.centre().z());
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 20000; ++i)
    points.push_back(rim + Vec3(random.uniform(body.min.x(), body.max.x()),
                                random.uniform(body.min.y(), body.max.y()),
                                random.uniform(body.min.z(), body.max.z())));
  const auto flags = insideFlags(surface, points);
  const double share = double(std::count(flags.begin(), flags.end(), 1)) / double(points.size());
  REQUIRE(share > 0.1);
  REQUIRE(share < 0.9);
  CHECK(overlapAt(at(rim)) == doctest::Approx(share * whole).epsilon(0.03));
}
