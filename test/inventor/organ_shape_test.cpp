#include "inventor/SoOrganShape.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <doctest/doctest.h>

#include <cstring>

#include "geometry/normals.h"
#include "geometry/primitives.h"
#include "inventor/init.h"
#include "inventor/offscreen_view.h"
#include "inventor/operating_room.h"

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
  OrganGeometry all() const { return {points, normals, cut, triangles, {}}; }
};

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
  shape->setGeometry(sphere.all());
  CHECK(boxOf(shape).getMax()[1] == doctest::Approx(0.2));
  // A hole joins the point (0, 0, 0) thrice: it is no triangle either.
  const std::vector<Triangle> holes(sphere.triangles.size(), Triangle{0, 0, 0});
  CHECK(trianglesOf(shape) == int(sphere.triangles.size()));
  shape->updateRange(0, 0, {{}, {}, {}, holes, {}});
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
  shape->setGeometry(sphere.all());
  CHECK(shape->revision.getValue() == before + 1);
  shape->updateRange(0, 0, {sphere.points, sphere.normals, sphere.cut, {}, {}});
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

  shape->setGeometry(narrow.all());
  const RgbImage narrowPicture = view.render(stage.room.root());
  shape->setGeometry(wide.all());
  const RgbImage widePicture = view.render(stage.room.root());
  CHECK(narrowPicture.pixels != widePicture.pixels);

  // Vertices: from narrow to wide in two ranges.
  shape->setGeometry(narrow.all());
  view.render(stage.room.root());
  std::uint64_t sent = shape->uploadedBytes();
  const std::size_t half = wide.points.size() / 2, rest = wide.points.size() - half;
  const auto range = [&](std::size_t from, std::size_t count) {
    shape->updateRange(int(from), 0,
                       {std::span(wide.points).subspan(from, count),
                        std::span(wide.normals).subspan(from, count),
                        std::span(wide.cut).subspan(from, count),
                        {},
                        {}});
  };
  range(0, half);
  view.render(stage.room.root());
  CHECK(shape->uploadedBytes() - sent == half * 40);  // 3 x 12 bytes and 4 of cut
  sent = shape->uploadedBytes();
  range(half, rest);
  CHECK(view.render(stage.room.root()).pixels == widePicture.pixels);
  CHECK(shape->uploadedBytes() - sent == rest * 40);

  // Triangles: some taken away and put back.
  const std::vector<Triangle> holes(100, Triangle{0, 0, 0});
  shape->updateRange(0, 50, {{}, {}, {}, holes, {}});
  CHECK(view.render(stage.room.root()).pixels != widePicture.pixels);
  sent = shape->uploadedBytes();
  shape->updateRange(0, 50, {{}, {}, {}, std::span(wide.triangles).subspan(50, 100), {}});
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
  shape->setGeometry(sphere.all());
  const RgbImage expected = view.render(stage.room.root());

  const std::size_t half = sphere.points.size() / 2, gap = 500;
  shape->setGeometry({std::span(sphere.points).first(half),
                      std::span(sphere.normals).first(half),
                      std::span(sphere.cut).first(half),
                      {},
                      {}});
  view.render(stage.room.root());
  shape->updateRange(int(half), int(gap),
                     {std::span(sphere.points).subspan(half),
                      std::span(sphere.normals).subspan(half),
                      std::span(sphere.cut).subspan(half),
                      sphere.triangles,
                      {}});
  CHECK(shape->triangleCount() == int(gap + sphere.triangles.size()));
  CHECK(view.render(stage.room.root()).pixels == expected.pixels);
}

TEST_CASE("one shape is drawn in two contexts, and outlives one of them") {
  Stage stage;
  const Arrays sphere(0.1);
  stage.room.organ()->setGeometry(sphere.all());
  OffscreenView first(160, 90);
  const RgbImage expected = first.render(stage.room.root());
  {
    OffscreenView second(160, 90);
    CHECK(second.render(stage.room.root()).pixels == expected.pixels);
  }
  stage.room.organ()->setGeometry(sphere.all());
  CHECK(first.render(stage.room.root()).pixels == expected.pixels);
}
