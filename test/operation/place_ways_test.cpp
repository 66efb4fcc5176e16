#include "operation/way/place_ways.h"

#include <doctest/doctest.h>

#include "geometry/primitives.h"
#include "operation/way/organ_section.h"
#include "support/block_organ.h"
#include "support/elastic_block.h"
#include "support/sentence.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

TriangleMesh boxOf(const Vec3& low, const Vec3& high) { return boxMesh({low, high}); }

LaidOrgan laid(TriangleMesh surface) {
  return {std::move(surface), {{"tip", {0.5, 1, 0.25}}}, Vec3::Constant(0.004)};
}

WayKey over(double across, double front, double depth) {
  WayKey key;
  key.kind = WayKey::Place::Over;
  key.place = {across, 0, front};
  key.depth = depth;
  return key;
}

Scenario withWay(std::vector<WayKey> keys) {
  Scenario scenario;
  scenario.organs[0].source.spacing = 0.004;
  scenario.tools.resize(1);
  scenario.tools[0].model = "scalpel";
  keys.front().time = 0.5;
  scenario.tools[0].way = OrganWay{"", std::move(keys)};
  return scenario;
}

Vec3 tip(WayKey key, const TriangleMesh& organ) {
  Scenario scenario = withWay({std::move(key)});
  placeWays(scenario, 0, laid(organ));
  return scenario.tools[0].keys[0].pose.position;
}

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 2e-5; }

}  // namespace

TEST_CASE("a section tells where an organ begins, ends and has its top, gaps and all") {
  TriangleMesh two = boxOf({0, 0, 0}, {0.1, 0.02, 0.03});
  append(two, boxOf({0, 0, 0.04}, {0.1, 0.05, 0.1}));
  const OrganSection section(two, 0.05);
  CHECK(section.back() == doctest::Approx(0.04));  // of the longer piece
  CHECK(section.front() == doctest::Approx(0.1));
  CHECK(section.tallest() == doctest::Approx(0.05));
  CHECK(section.lowest() == doctest::Approx(0));
  CHECK(section.topAt(0.01) == doctest::Approx(0.02));
  CHECK(section.topAt(0.07) == doctest::Approx(0.05));
  CHECK(section.topAt(0.033) == doctest::Approx(0.02));  // in the gap: of the nearer side
  CHECK(section.topAt(0.2) == doctest::Approx(0.05));
  CHECK(OrganSection(two, 0.11).empty());
  CHECK(test::refuses([&] { OrganSection(two, 0.11).topAt(0); }, "does not meet the organ"));
}

TEST_CASE("a place over an organ follows its size, its place and its slant") {
  const TriangleMesh slab = boxOf({-0.1, 0, -0.05}, {0.1, 0.04, 0.05});
  CHECK(near(tip(over(0.25, 0.8, 0.01), slab), {-0.05, 0.03, 0.03}));
  const TriangleMesh moved = transformed(slab, {{1, 0.2, -3}, Eigen::Quaterniond::Identity()});
  CHECK(near(tip(over(0.25, 0.8, 0.01), moved), {0.95, 0.23, -2.97}));
  // Turned about the upright axis by 45 degrees: the plane at a quarter of its width meets less of
  // it, and places lie on what it meets.
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.25 * 3.14159265358979, Vec3::UnitY()));
  const TriangleMesh turned = transformed(slab, {Vec3::Zero(), turn});
  for (const double front : {0.05, 0.5, 0.95}) {
    const Vec3 p = tip(over(0.25, front, 0.01), turned);
    const Vec3 own = turn.inverse() * p;
    CHECK(std::abs(own.x()) <= 0.1);
    CHECK(std::abs(own.z()) <= 0.05);
    CHECK(p.y() == doctest::Approx(0.03));
  }
  // Tilted: the top is followed.
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
  const TriangleMesh tilted = transformed(slab, {Vec3::Zero(), tilt});
  for (const double front : {0.4, 0.5, 0.7}) {
    const Vec3 own = tilt.inverse() * tip(over(0.5, front, 0.01), tilted);
    CHECK(own.y() == doctest::Approx(0.04 - 0.01 * std::cos(0.3)).epsilon(0.01));
  }
}

TEST_CASE("depths are limited to half of the organ, and heights above it are not") {
  const TriangleMesh thin = boxOf({-0.1, 0, -0.05}, {0.1, 0.03, 0.05});
  CHECK(tip(over(0.5, 0.5, 0.1), thin).y() == doctest::Approx(0.015));
  CHECK(tip(over(0.5, 0.5, -0.1), thin).y() == doctest::Approx(0.13));
  WayKey share = over(0.5, 0.5, 0.4);
  share.share = true;
  CHECK(tip(share, thin).y() == doctest::Approx(0.018));
  CHECK(near(tip(over(0.5, 1.5, -0.02), thin), {0, 0.05, 0.1}));  // beside it
}

TEST_CASE("landmarks, fractions of the box and offsets are places too") {
  const TriangleMesh slab = boxOf({0, 0, 0}, {0.2, 0.04, 0.1});
  WayKey key;
  key.kind = WayKey::Place::Landmark;
  key.landmark = "tip";
  CHECK(near(tip(key, slab), {0.1, 0.04, 0.025}));
  key.depth = 0.01;
  CHECK(near(tip(key, slab), {0.1, 0.03, 0.025}));
  key.landmark = "tail";
  CHECK(test::refuses([&] { tip(key, slab); }, "has no landmark \"tail\""));
  WayKey box;
  box.kind = WayKey::Place::Box;
  box.place = {0.25, 2, 0.5};
  box.offset = {0.01, 0, 0};
  box.cells = {0, 0, -0.5};
  CHECK(near(tip(box, slab), {0.06, 0.08, 0.048}));
  CHECK(test::refuses([&] { tip(box, TriangleMesh()); }, "has no surface"));
}

TEST_CASE(
    "a key that is reached with a speed takes longer on a larger organ, and falls on a frame") {
  std::vector<WayKey> keys = {over(0.5, 0.1, 0.01), over(0.5, 0.9, 0.01), {}};
  keys[1].speed = 0.05;
  keys[2].wait = 0.25;
  for (const double size : {0.05, 0.1, 0.3}) {
    Scenario scenario = withWay(keys);
    scenario.after = 0.4;
    CHECK(hasWays(scenario));
    CHECK(test::refuses([&] { frameInput(scenario, 0); }, "is not placed on its organ"));
    placeWays(scenario, 0, laid(boxOf({0, 0, 0}, {size, 0.04, size})));
    const std::vector<ToolKey>& placed = scenario.tools[0].keys;
    const double frames = (placed[1].time - 0.5) * scenario.frameRate;
    CHECK(std::abs(frames - std::round(frames)) < 1e-2);
    CHECK(placed[1].time - 0.5 == doctest::Approx(0.8 * size / 0.05).epsilon(0.03));
    CHECK(placed[2].time == doctest::Approx(placed[1].time + 0.25));
    CHECK(placed[2].pose.position == placed[1].pose.position);
    CHECK(scenario.duration >= placed[2].time + 0.4);
    CHECK(scenario.duration < placed[2].time + 0.51);
    frameInput(scenario, 0);
  }
}

TEST_CASE("on elastic tissue a way follows the surface that has sunk, and leaves the state alone") {
  // A tall block that its weight shortens.
  Simulation simulation = test::elasticBlock({6, 14, 6}, 0.008, test::thinScalpel());
  Scenario scenario = withWay({over(0.5, 0.5, -0.05), over(0.5, 0.5, 0.01)});
  scenario.organs[0].tissue.elastic = true;
  scenario.tools[0].way->keys[1].speed = 0.01;  // long after it has sunk
  const TriangleMesh rest = simulation.organ().surface.mesh();
  placeWays(scenario, 0, laid(rest));
  const double before = scenario.tools[0].keys[1].pose.position.y();
  const std::uint64_t state = simulation.stateHash();
  settleWays(scenario, simulation);
  CHECK(simulation.stateHash() == state);
  CHECK(simulation.frame() == 0);
  const double after = scenario.tools[0].keys[1].pose.position.y();
  CHECK(after < before - 0.0005);
  CHECK(after > before - 0.05);
}
