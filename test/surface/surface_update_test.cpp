#include "surface/surface_update.h"

#include <doctest/doctest.h>

using namespace resect;

namespace {

struct Arrays {
  std::vector<Vec3f> points, normals, rest;
  std::vector<float> cut;
  std::vector<Triangle> triangles;

  explicit Arrays(int count) {
    for (int i = 0; i < count; ++i) {
      const float at = float(i);
      points.push_back({at, 1, 0});
      normals.push_back({0, 0, at});
      rest.push_back({at, 0, 0});
      cut.push_back(at / float(count));
      triangles.push_back({i, (i + 1) % count, (i + 2) % count});
    }
  }
};

void checkSame(const SurfaceCopy& copy, const Arrays& all) {
  CHECK(copy.points == all.points);
  CHECK(copy.normals == all.normals);
  CHECK(copy.rest == all.rest);
  CHECK(copy.cut == all.cut);
  CHECK(copy.triangles == all.triangles);
}

}  // namespace

TEST_CASE("an update of everything makes any copy the surface") {
  const Arrays few(5), many(9);
  SurfaceCopy copy;
  for (const Arrays* all : {&many, &few, &many}) {
    apply(wholeSurface(all->points, all->normals, all->cut, all->triangles, all->rest), copy);
    checkSame(copy, *all);
  }
  apply(wholeSurface(few.points, few.normals, few.cut, few.triangles), copy);
  CHECK(copy.rest == few.points);  // tissue at rest
  apply(wholeSurface({}, {}, {}, {}), copy);
  CHECK(copy.points.empty());
  CHECK(copy.triangles.empty());
}

TEST_CASE("each kind of change reaches its own arrays; later ranges overwrite earlier ones") {
  Arrays all(20);
  SurfaceCopy copy;
  apply(wholeSurface(all.points, all.normals, all.cut, all.triangles, all.rest), copy);
  SurfaceUpdate update;
  CHECK(update.empty());
  addMovedVertices(update, {3, 0}, all.points, all.normals);
  CHECK(update.empty());  // a range of nothing

  all.points[4] = {7, 7, 7};
  addMovedVertices(update, {2, 8}, all.points, all.normals);
  all.points[5] = {8, 8, 8};
  all.normals[5] = {1, 0, 0};
  addMovedVertices(update, {5, 2}, all.points, all.normals);
  CHECK(update.points.size() == 10);
  CHECK(update.rest.empty());
  apply(update, copy);
  checkSame(copy, all);

  update = {};
  all.rest[19] = {9, 9, 9};
  all.cut[0] = 0.7f;
  addNewVertices(update, {19, 1}, all.rest, all.cut);
  addNewVertices(update, {0, 2}, all.rest, all.cut);
  all.triangles[11] = {0, 0, 0};
  addNewTriangles(update, {11, 1}, all.triangles);
  CHECK(update.points.empty());
  apply(update, copy);
  checkSame(copy, all);
}

TEST_CASE("a copy grows to the end of a range, and triangles that nobody named are holes") {
  const Arrays all(10);
  SurfaceCopy copy;
  SurfaceUpdate update;
  addNewVertices(update, {6, 4}, all.rest, all.cut);
  addMovedVertices(update, {6, 4}, all.points, all.normals);
  addNewTriangles(update, {8, 2}, all.triangles);
  apply(update, copy);
  CHECK(copy.points.size() == 10);
  CHECK(copy.normals.size() == 10);
  CHECK(copy.rest.size() == 10);
  CHECK(copy.cut.size() == 10);
  CHECK(copy.points[9] == all.points[9]);
  CHECK(copy.triangles[7] == Triangle{0, 0, 0});
  CHECK(copy.triangles[8] == all.triangles[8]);
}
