#include "operation/blood/bare_vessels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/topology.h"
#include "operation/blood/bleeding_block.h"
#include "operation/blood/vessel_walls.h"
#include "organ/picture/picture_vessels.h"

using namespace resect;
using test::kCut;
using test::step;

namespace {

// The block of bleeding_block.h, with the tissue round the vein from 25 to 40 mm removed.
Simulation baredBlock() {
  Simulation simulation = test::bleedingBlock();
  const Lattice& lattice = simulation.organ().rest.lattice;
  std::vector<TissueEdit> edits;
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) {
    const Vec3 p = lattice.centre(lattice.cell(cell));
    const Vec3 off = p - kCut;
    if (p.x() > 0.025 && p.x() < 0.040 && std::hypot(off.y(), off.z()) < 0.008)
      edits.push_back({0, 0, RemoveCell{cell, 0.0005}});
  }
  step(simulation, std::move(edits));
  return simulation;
}

TriangleMesh meshOf(const SurfaceCopy& walls) {
  TriangleMesh mesh;
  for (const Vec3f& p : walls.points) mesh.points.push_back(p.cast<double>());
  mesh.triangles = walls.triangles;
  return mesh;
}

// Radius of the wall at x, m: half of what it measures across, in the thinnest and the thickest
// direction.
std::pair<double, double> radiiAt(const BareVessels& vessels, double x) {
  double least = 1, most = 0;
  for (const Vec3f& p : vessels.walls.points) {
    if (std::abs(double(p.x()) - x) > 0.4e-3) continue;
    const double r = std::hypot(double(p.y()) - kCut.y(), double(p.z()) - kCut.z());
    least = std::min(least, r), most = std::max(most, r);
  }
  return {least, most};
}

}  // namespace

TEST_CASE("a bare vessel is a closed wall round its axis, about as thick as the vessel") {
  CHECK(bareVessels(test::bleedingBlock()) == nullptr);
  const auto vessels = bareVessels(baredBlock());
  REQUIRE(vessels);
  const SurfaceCopy& walls = vessels->walls;
  REQUIRE_FALSE(walls.triangles.empty());
  CHECK(walls.normals.size() == walls.points.size());
  CHECK(walls.rest.size() == walls.points.size());
  CHECK(walls.cut.size() == walls.points.size());
  CHECK(vessels->clips.triangles.empty());
  const Topology form = topology(meshOf(walls));
  CHECK(form.closed());
  CHECK(form.oriented());
  const double outside = 0.002 + wallOf(VesselKind::PortalVein, 0.002);
  const auto [least, most] = radiiAt(*vessels, 0.0321);
  CHECK(least > 0.7 * outside);
  CHECK(most < 1.3 * outside);
  for (std::size_t v = 0; v < walls.points.size(); ++v) {
    CHECK(walls.normals[v].norm() == doctest::Approx(1).epsilon(1e-4));
    CHECK(walls.cut[v] == 0);  // outside of a portal vein that heat has not touched
  }
}

TEST_CASE("a clip lies across its vessel, grips it on both sides, and presses it flat") {
  Simulation simulation = baredBlock();
  const double share = (kCut.x() + 0.02) / 0.07;
  step(simulation, {{0, 0, PlaceClip{0, share}}});
  const auto vessels = bareVessels(simulation);
  REQUIRE(vessels);
  REQUIRE_FALSE(vessels->clips.triangles.empty());
  CHECK(vessels->clipNormals.size() == vessels->clips.points.size());
  const Topology form = topology(vessels->clips);
  CHECK(form.closed());
  CHECK(form.oriented());
  const Aabb box = bounds(vessels->clips);
  CHECK((box.centre() - kCut).norm() < 0.0015);
  CHECK(box.size().x() < 0.0015);                   // narrow along the vessel
  CHECK(box.size().tail<2>().norm() < 0.0130);      // a few millimetres across it
  CHECK(box.size().tail<2>().norm() > 2 * 0.0024);  // more than the vessel
  const auto [least, most] = radiiAt(*vessels, kCut.x());
  CHECK(least < 0.4 * most);
  CHECK(vessels->box.size().norm() >= box.size().norm());
}

TEST_CASE("a divided vessel shows its lumen at open ends, and none where heat has sealed it") {
  Simulation simulation = baredBlock();
  const double share = (kCut.x() + 0.02) / 0.07;
  step(simulation, {{0, 0, DivideVessel{0, share}}});
  const auto open = bareVessels(simulation);
  REQUIRE(open);
  const auto inside = [](const BareVessels& vessels) {
    return std::ranges::count_if(vessels.walls.cut, [](float look) { return look >= kLookInside; });
  };
  CHECK(inside(*open) > 0);
  CHECK(topology(meshOf(open->walls)).closed());
  // The ends have drawn back from the cut.
  CHECK(radiiAt(*open, kCut.x()).second == 0);
  for (int i = 0; i < 240; ++i) step(simulation, {{0, 0, Heat{kCut, 0.005, 60}}});
  REQUIRE(simulation.organ().vessels.injuries[0].sealed == 3);
  const auto sealed = bareVessels(simulation);
  CHECK(inside(*sealed) == 0);
  CHECK(std::ranges::max(sealed->walls.cut) > 0.9f);  // shrivelled
  CHECK(std::ranges::max(sealed->walls.cut) <= 1);
  CHECK(topology(meshOf(sealed->walls)).closed());
}
