#include "inventor/gl/SoMarchingCubes.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/init.h"

using namespace resect;

namespace {

constexpr int kNodes = 24;

// 100 in the middle, 50 at a distance of 0.3 from it, in the unit cube.
float ballLevel(int x, int y, int z) {
  const double h = 1.0 / (kNodes - 1);
  return float(100 - 50 * std::hypot(x * h - 0.5, y * h - 0.5, z * h - 0.5) / 0.3);
}

std::string sceneText() {
  std::string values;
  for (int z = 0; z < kNodes; ++z)
    for (int y = 0; y < kNodes; ++y)
      for (int x = 0; x < kNodes; ++x) values += std::to_string(ballLevel(x, y, z)) + " ";
  return "#Inventor V2.1 ascii\nSeparator { DEF SHAPE OrganShape {\n"
         "  points = DEF SURFACE MarchingCubes { dims 24 24 24 value [ " +
         values +
         "] } . points\n"
         "  normals = USE SURFACE . normals\n"
         "  coordIndex = USE SURFACE . coordIndex\n} }\n";
}

struct CubesScene {
  SoSeparator* root;
  SoOrganShape* shape;

  CubesScene() {
    initInventor();
    const std::string text = sceneText();
    SoInput input;
    input.setBuffer(text.data(), text.size());
    root = SoDB::readAll(&input);
    REQUIRE(root);
    root->ref();
    shape = static_cast<SoOrganShape*>(SoNode::getByName("SHAPE"));
    REQUIRE(shape);
  }
  ~CubesScene() { root->unref(); }

  TriangleMesh mesh() const {
    TriangleMesh mesh;
    for (int i = 0; i < shape->points.getNum(); ++i)
      mesh.points.emplace_back(shape->points[i][0], shape->points[i][1], shape->points[i][2]);
    for (int i = 0; i + 3 < shape->coordIndex.getNum() + 1; i += 4)
      mesh.triangles.push_back(
          {shape->coordIndex[i], shape->coordIndex[i + 1], shape->coordIndex[i + 2]});
    return mesh;
  }
};

}  // namespace

TEST_CASE("a plain .iv file connects the engine to the organ shape: the ball is there, closed") {
  CubesScene scene;
  const TriangleMesh mesh = scene.mesh();
  REQUIRE(mesh.triangles.size() > 500);
  CHECK(topology(mesh).closed());
  CHECK(topology(mesh).oriented());
  CHECK(volume(mesh) == doctest::Approx(4.0 / 3 * std::numbers::pi * 0.027).epsilon(0.01));
  for (int i = 0; i < scene.shape->normals.getNum(); i += 37) {
    const SbVec3f away = scene.shape->points[i] - SbVec3f(0.5f, 0.5f, 0.5f);
    CHECK(scene.shape->normals[i].dot(away) / away.length() > 0.99f);
  }
  SoGetBoundingBoxAction box(SbViewportRegion(100, 100));
  box.apply(scene.root);
  CHECK(box.getBoundingBox().getMax()[0] == doctest::Approx(0.8).epsilon(0.01));
  CHECK(scene.shape->triangleCount() == int(mesh.triangles.size()));
}

TEST_CASE("another iso level moves the surface through the connection") {
  CubesScene scene;
  SoEngineOutput* output = nullptr;
  REQUIRE(scene.shape->points.getConnectedEngine(output));
  auto* engine = static_cast<SoMarchingCubes*>(output->getContainer());
  const double before = volume(scene.mesh());
  engine->iso = 75;  // half the radius
  CHECK(volume(scene.mesh()) == doctest::Approx(before / 8).epsilon(0.03));
  engine->iso = 200;
  CHECK(scene.mesh().triangles.empty());
}

TEST_CASE("a grid with too few values or nodes gives no surface and no harm") {
  initInventor();
  auto* engine = new SoMarchingCubes;
  engine->ref();
  auto* shape = new SoOrganShape;
  shape->ref();
  shape->coordIndex.connectFrom(&engine->coordIndex);
  engine->dims.setValue(1, 5, 5);
  CHECK(shape->coordIndex.getNum() == 0);
  engine->dims.setValue(-3, 5, 5);
  CHECK(shape->coordIndex.getNum() == 0);
  engine->dims.setValue(4, 4, 4);
  engine->value.setNum(1);
  engine->value.set1Value(0, 100.0f);
  CHECK(shape->coordIndex.getNum() > 0);
  shape->unref();
  engine->unref();
}
