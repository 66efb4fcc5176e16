// Random edits: the surface stays closed and equal to a rebuild.

#include <doctest/doctest.h>

#include "anatomy/visible_human.h"
#include "base/parallel.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "support/random_edits.h"
#include "support/surface_look.h"
#include "surface/surface_tracker.h"

using namespace resect;

namespace {

struct RandomOutcome {
  std::vector<std::int64_t> trianglesAfterEdit;
  SurfaceTracker::Compact surface;
};

// 1000 random edits on the organ; every tenth time the surface is compared with a rebuild.
RandomOutcome editAtRandom(const Discretization& cells, int threads) {
  const ThreadLimit limit(threads);
  ColourField field(cells, 2);
  SurfaceTracker tracker(field, 50);
  Discretization now = cells;
  Random random(2024);
  RandomOutcome outcome;
  for (int edit = 0; edit < 1000; ++edit) {
    for (const auto& [cell, value] : test::randomEdit(cells, random)) {
      field.setCellValue(cell, value);
      now.value.set(cell, value);
    }
    tracker.update(field, field.update());
    outcome.trianglesAfterEdit.push_back(tracker.triangleCount());
    if (edit % 10 != 9) continue;
    outcome.surface = test::withLook(tracker, field);
    const auto [mesh, normals, cut] = test::withLook(ColourField(now, 2), 50);
    REQUIRE(outcome.surface.mesh.points == mesh.points);
    REQUIRE(outcome.surface.mesh.triangles == mesh.triangles);
    REQUIRE(outcome.surface.normals == normals);
    const Topology shape = topology(mesh);
    REQUIRE(shape.closed());
    REQUIRE(shape.oriented());
    REQUIRE(shape.manifold());
  }
  return outcome;
}

}  // namespace

TEST_CASE(
    "through 1000 random edits of an organ the surface equals a rebuild bit for bit, at 1, 2 and 3 "
    "threads") {
  const auto liver = test::visibleHumanLiver();
  const TriangleMesh mesh = liver ? *liver : torusMesh({0, 0, 0}, 0.07, 0.035);
  const Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), 0.008));
  const RandomOutcome one = editAtRandom(cells, 1);
  for (const int threads : {2, 3}) {
    const RandomOutcome more = editAtRandom(cells, threads);
    CHECK(more.trianglesAfterEdit == one.trianglesAfterEdit);
    CHECK(more.surface.mesh.points == one.surface.mesh.points);
    CHECK(more.surface.mesh.triangles == one.surface.mesh.triangles);
    CHECK(more.surface.normals == one.surface.normals);
    CHECK(more.surface.cut == one.surface.cut);
  }
}
