#include "inventor/gl/SoOrganShape.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <doctest/doctest.h>

#include <cstring>
#include <span>

#include "base/random.h"
#include "geometry/normals.h"
#include "geometry/primitives.h"
#include "inventor/init.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operating_room.h"

using namespace resect;

namespace {

// A sphere in the arrays a shape takes; the upper part is cut.
struct Arrays {
  std::vector<Vec3f> points, normals;
  std::vector<float> cut;
  std::vector<Triangle> triangles;

  explicit Arrays(double radius, int rings = 16) {
    const TriangleMesh sphere = sphereMesh({0, radius, 0}, radius, rings);
    for (const Vec3& n : pointNormals(sphere)) normals.push_back(n.cast<float>());
    for (const Vec3& p : sphere.points) {
      points.push_back(p.cast<float>());
      cut.push_back(p.y() > 1.5 * radius ? 1.0f : 0.0f);
    }
    triangles = sphere.triangles;
  }
  SurfaceUpdate all() const { return wholeSurface(points, normals, cut, triangles); }
  // Parts of it, as of a surface at rest.
  SurfaceUpdate vertices(std::size_t first, std::size_t count) const {
    SurfaceUpdate update = moved(first, count);
    addNewVertices(update, {std::int32_t(first), std::int32_t(count)}, points, cut);
    return update;
  }
  SurfaceUpdate moved(std::size_t first, std::size_t count) const {
    SurfaceUpdate update;
    addMovedVertices(update, {std::int32_t(first), std::int32_t(count)}, points, normals);
    return update;
  }
};

SurfaceUpdate trianglesFrom(int first, std::span<const Triangle> triangles) {
  SurfaceUpdate update;
  update.newTriangles = {{first, std::int32_t(triangles.size())}};
  update.triangles.assign(triangles.begin(), triangles.end());
  return update;
}

SbBox3f boxOf(SoNode* node) {
  SoGetBoundingBoxAction action(SbViewportRegion(64, 64));
  action.apply(node);
  return action.getBoundingBox();
}

int trianglesOf(SoNode* node) {
  SoCallbackAction action;
  int count = 0;
  action.addTriangleCallback(
      SoOrganShape::getClassTypeId(),
      [](void* counter, SoCallbackAction*, const SoPrimitiveVertex*, const SoPrimitiveVertex*,
         const SoPrimitiveVertex*) { ++*static_cast<int*>(counter); },
      &count);
  action.apply(node);
  return count;
}

struct Stage {
  OperatingRoom room;
  Stage() {
    const Aabb box{{-0.1, 0, -0.1}, {0.1, 0.2, 0.1}};
    room.lightUp(box);
    room.look(RoomView::Surgeon, box, 16.0 / 9.0);
  }
};

}  // namespace

TEST_CASE("an organ shape has a name in Inventor files, without the So") {
  initInventor();
  const char* text = "#Inventor V2.1 ascii\nSeparator { OrganShape { } }\n";
  SoInput input;
  input.setBuffer(text, std::strlen(text));
  SoSeparator* root = SoDB::readAll(&input);
  REQUIRE(root);
  root->ref();
  REQUIRE(root->getNumChildren() == 1);
  CHECK(root->getChild(0)->isOfType(SoOrganShape::getClassTypeId()));
  CHECK(root->getChild(0)->getTypeId().getName() == "OrganShape");
  root->unref();
}

TEST_CASE("the box of an organ shape holds its triangles, not its unused vertices") {
  initInventor();
  auto* shape = new SoOrganShape;
  shape->ref();
  CHECK(boxOf(shape).isEmpty());
  Arrays sphere(0.1);
  sphere.points.push_back({100, 100, 100});
  sphere.normals.push_back({0, 1, 0});
  sphere.cut.push_back(0);
  shape->update(sphere.all());
  CHECK(boxOf(shape).getMax()[1] == doctest::Approx(0.2));
  // A hole joins the point (0, 0, 0) thrice: it is no triangle either.
  const std::vector<Triangle> holes(sphere.triangles.size(), Triangle{0, 0, 0});
  CHECK(trianglesOf(shape) == int(sphere.triangles.size()));
  shape->update(trianglesFrom(0, holes));
  CHECK(boxOf(shape).isEmpty());
  CHECK(trianglesOf(shape) == 0);
  shape->unref();
}

TEST_CASE("every change raises the revision") {
  initInventor();
  auto* shape = new SoOrganShape;
  shape->ref();
  const Arrays sphere(0.1);
  const int before = shape->revision.getValue();
  shape->update(sphere.all());
  CHECK(shape->revision.getValue() == before + 1);
  shape->update(sphere.vertices(0, sphere.points.size()));
  CHECK(shape->revision.getValue() == before + 2);
  shape->update({});  // nothing
  CHECK(shape->revision.getValue() == before + 2);
  CHECK(shape->vertexCount() == int(sphere.points.size()));
  CHECK(shape->triangleCount() == int(sphere.triangles.size()));
  shape->unref();
}

TEST_CASE("changing ranges gives the same picture as giving all, and sends only the ranges") {
  Stage stage;
  SoOrganShape* shape = stage.room.organ();
  OffscreenView view(160, 90);
  const Arrays wide(0.1), narrow(0.08);

  shape->update(narrow.all());
  const RgbImage narrowPicture = view.render(stage.room.root());
  shape->update(wide.all());
  const RgbImage widePicture = view.render(stage.room.root());
  CHECK(narrowPicture.pixels != widePicture.pixels);

  // Vertices: from narrow to wide in two ranges.
  shape->update(narrow.all());
  view.render(stage.room.root());
  std::uint64_t sent = shape->uploadedBytes();
  const std::size_t half = wide.points.size() / 2, rest = wide.points.size() - half;
  const auto range = [&](std::size_t from, std::size_t count) {
    shape->update(wide.vertices(from, count));
  };
  range(0, half);
  view.render(stage.room.root());
  CHECK(shape->uploadedBytes() - sent == half * 40);  // 3 x 12 bytes and 4 of cut
  sent = shape->uploadedBytes();
  range(half, rest);
  CHECK(view.render(stage.room.root()).pixels == widePicture.pixels);
  CHECK(shape->uploadedBytes() - sent == rest * 40);

  // Vertices that only move keep rest place and cut: points and normals are sent.
  shape->update(narrow.all());
  shape->update(narrow.vertices(0, 1));
  view.render(stage.room.root());
  sent = shape->uploadedBytes();
  shape->update(wide.moved(0, half));
  view.render(stage.room.root());
  CHECK(shape->uploadedBytes() - sent == half * 24);
  // Both parts of what is new arrive, each in its buffer.
  shape->update(wide.moved(half, rest));
  SurfaceUpdate atRest;
  addNewVertices(atRest, {0, std::int32_t(wide.points.size())}, wide.points, wide.cut);
  shape->update(atRest);
  sent = shape->uploadedBytes();
  CHECK(view.render(stage.room.root()).pixels == widePicture.pixels);
  CHECK(shape->uploadedBytes() - sent == rest * 24 + wide.points.size() * 16);

  // Triangles: some taken away and put back.
  const std::vector<Triangle> holes(100, Triangle{0, 0, 0});
  shape->update(trianglesFrom(50, holes));
  CHECK(view.render(stage.room.root()).pixels != widePicture.pixels);
  sent = shape->uploadedBytes();
  shape->update(trianglesFrom(50, std::span(wide.triangles).subspan(50, 100)));
  CHECK(view.render(stage.room.root()).pixels == widePicture.pixels);
  CHECK(shape->uploadedBytes() - sent == 100 * 12);

  // Nothing changed: nothing sent.
  sent = shape->uploadedBytes();
  view.render(stage.room.root());
  CHECK(shape->uploadedBytes() == sent);
}

TEST_CASE("a shape grows when a range reaches beyond its end") {
  Stage stage;
  SoOrganShape* shape = stage.room.organ();
  OffscreenView view(160, 90);
  const Arrays sphere(0.1);
  shape->update(sphere.all());
  const RgbImage expected = view.render(stage.room.root());

  const std::size_t half = sphere.points.size() / 2, gap = 500;
  shape->update(wholeSurface(std::span(sphere.points).first(half),
                             std::span(sphere.normals).first(half),
                             std::span(sphere.cut).first(half), {}));
  view.render(stage.room.root());
  SurfaceUpdate grown = sphere.vertices(half, sphere.points.size() - half);
  grown.newTriangles = {{std::int32_t(gap), std::int32_t(sphere.triangles.size())}};
  grown.triangles = sphere.triangles;
  shape->update(grown);
  CHECK(shape->triangleCount() == int(gap + sphere.triangles.size()));
  CHECK(view.render(stage.room.root()).pixels == expected.pixels);
}

TEST_CASE("one shape is drawn in two contexts, and outlives one of them") {
  Stage stage;
  const Arrays sphere(0.1);
  stage.room.organ()->update(sphere.all());
  OffscreenView first(160, 90);
  const RgbImage expected = first.render(stage.room.root());
  {
    OffscreenView second(160, 90);
    CHECK(second.render(stage.room.root()).pixels == expected.pixels);
  }
  stage.room.organ()->update(sphere.all());
  CHECK(first.render(stage.room.root()).pixels == expected.pixels);
}

TEST_CASE("a ray meets the shape where its nearest triangle is now, and no holes") {
  initInventor();
  auto* shape = new SoOrganShape;
  shape->ref();
  Arrays sphere(0.1, 60);
  shape->update(sphere.all());
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 centre(0, 0.1, 0),
        way =
            Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
    const auto point = shape->firstPointOn({centre + 0.5 * way, -way});
    REQUIRE(point);
    // A chord of a circle of 60 rings sags by 1.4e-4 of the radius, in both directions.
    CHECK((point->point - centre).norm() == doctest::Approx(0.1).epsilon(1e-3));
    CHECK((point->point - (centre + 0.1 * way)).norm() < 1e-4);
    CHECK(point->normal.dot(way) > 0.99);
    CHECK_FALSE(shape->firstPointOn({centre + 0.5 * way, way}));
  }
  const Ray down{Vec3(0.003, 1, 0.002), Vec3(0, -2, 0)};
  CHECK(shape->firstPointOn(down)->point.y() == doctest::Approx(0.2).epsilon(1e-3));
  for (Vec3f& p : sphere.points) p.y() -= 0.05f;
  shape->update(sphere.moved(0, sphere.points.size()));
  CHECK(shape->firstPointOn(down)->point.y() == doctest::Approx(0.15).epsilon(1e-3));
  // The upper half is cut away: the ray goes on to the lower one.
  for (Triangle& t : sphere.triangles)
    if (sphere.points[std::size_t(t[0])].y() > 0.05f) t = {0, 0, 0};
  shape->update(trianglesFrom(0, sphere.triangles));
  CHECK(shape->firstPointOn(down)->point.y() == doctest::Approx(-0.05).epsilon(1e-3));
  shape->unref();
}
