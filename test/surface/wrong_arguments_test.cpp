// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include "support/block_organ.h"
#include "support/sentence.h"
#include "surface/surface_tracker.h"
#include "surface/surface_update.h"

using namespace resect;
using test::refuses;

TEST_CASE("an iso level out of range leaves the surface as it is") {
  const ColourField field(test::ball(8), 2);
  CHECK(refuses([&] { SurfaceTracker(field, 0.f); }, "iso level is 0"));
  CHECK(refuses([&] { buildFieldAndSurface(test::ball(8), 2, 100.f); }, "iso level is 100"));
  SurfaceTracker surface(field, 50.f);
  const TriangleMesh before = surface.mesh();
  CHECK(refuses([&] { surface.setIso(field, 99.f); }, "iso level is 99"));
  CHECK(surface.iso() == 50.f);
  CHECK(surface.mesh().points == before.points);
}

TEST_CASE("how a surface looks is not told before it was made") {
  const ColourField field(test::ball(8), 2);
  SurfaceTracker surface(field, 50.f);
  CHECK(refuses([&] { surface.normals(); }, "call updateLook() first"));
  CHECK(refuses([&] { surface.cut(); }, "call updateLook() first"));
  surface.updateLook(field);
  CHECK(surface.normals().size() == surface.points().size());
}

TEST_CASE("an update whose ranges do not fit their values leaves the copy as it is") {
  const std::vector<Vec3f> three(3, Vec3f::UnitX());
  const std::vector<float> cut(3, 0.f), fewer(2, 0.f);
  CHECK(
      refuses([&] { wholeSurface(three, three, fewer, {}); }, "3 points have 3 normals, 2 shares"));
  SurfaceUpdate update;
  for (const IndexRange range : {IndexRange{-1, 2}, IndexRange{2, 2}, IndexRange{0, -1}}) {
    CHECK(refuses([&] { addNewVertices(update, range, three, cut); }, "is not among"));
    CHECK(refuses([&] { addMovedVertices(update, range, three, three); }, "is not among"));
    CHECK(refuses([&] { addNewTriangles(update, range, {}); }, "is not among"));
  }
  CHECK(update.empty());
  SurfaceCopy copy;
  apply(wholeSurface(three, three, cut, {}), copy);
  update.everything = true;
  update.newTriangles = {{0, 2}};
  update.triangles.resize(1);
  CHECK(refuses([&] { apply(update, copy); }, "1 values were given for ranges of 2"));
  update.newTriangles = {{-5, 1}};
  CHECK(refuses([&] { apply(update, copy); }, "numbers from 0"));
  CHECK(copy.points == three);
}
