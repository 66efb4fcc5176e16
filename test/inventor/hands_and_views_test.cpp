// What mouse and keys do beyond the first operation: manipulators dragged, modifiers, views.
#include <Inventor/SoPath.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/nodekits/SoBaseKit.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <doctest/doctest.h>

#include "base/random.h"
#include "support/operating_bench.h"

using namespace resect;
using test::OperatingBench;

TEST_CASE(
    "a handle box that is dragged moves its tool and does not grow it; a trackball turns it") {
  OperatingBench bench;
  const SbVec2s at = bench.pixelOf(2);
  bench.click(at);
  REQUIRE(bench.tools().how() == ToolHandling::Hold::HandleBox);
  const Pose before = bench.tools().pose(2);
  bench.drag(at, {short(at[0] - 60), short(at[1] + 20)});
  REQUIRE(bench.tools().how() == ToolHandling::Hold::HandleBox);
  const Pose moved = bench.tools().pose(2);
  CHECK((moved.position - before.position).norm() > 0.02);
  CHECK(moved.rotation.angularDistance(before.rotation) < 1e-3);
  CHECK(bench.session->room().toolTransform(2)->scaleFactor.getValue() == SbVec3f(1, 1, 1));

  bench.click(bench.pixelOf(2), SoMouseButtonEvent::BUTTON2);
  REQUIRE(bench.tools().how() == ToolHandling::Hold::Trackball);
  const SbVec2s on = bench.pixelOf(2);
  bench.drag(on, {short(on[0] + 50), short(on[1] + 30)});
  CHECK(bench.tools().pose(2).rotation.angularDistance(moved.rotation) > 0.1);
}

TEST_CASE("a handle box's cube for scaling neither grows its tool nor moves it") {
  OperatingBench bench;
  bench.click(bench.pixelOf(2));
  REQUIRE(bench.tools().how() == ToolHandling::Hold::HandleBox);
  REQUIRE(bench.key(SoKeyboardEvent::UP_ARROW));
  const Pose before = bench.tools().pose(2);
  const Vec3 middle = bench.session->middleOfTool(2);
  // Near enough that the cube is more than a few pixels.
  SoPerspectiveCamera* camera = bench.session->room().camera();
  camera->position.setValue(float(middle.x()) + 0.06f, 0.25f, 0.25f);
  camera->pointAt(SbVec3f(float(middle.x()), float(middle.y()), float(middle.z())));
  camera->nearDistance = 0.01f;

  SoTransform* transform = bench.session->room().toolTransform(2);
  SoDragger* box = static_cast<SoTransformManip*>(transform)->getDragger();
  struct Drag {
    SoNode* cube;
    int begun = 0;
  } drag{box->getPart("uniform3", false)};
  box->addStartCallback(
      [](void* told, SoDragger* dragger) {
        auto& [cube, begun] = *static_cast<Drag*>(told);
        begun += static_cast<const SoFullPath*>(dragger->getPickPath())->containsNode(cube);
      },
      &drag);
  double strayed = 0;  // at any time
  bench.tools().changed = [&, next = bench.tools().changed] {
    next();
    strayed = std::max(strayed, (bench.tools().pose(2).position - before.position).norm());
  };

  SoSearchAction find;
  find.setNode(drag.cube);
  find.setSearchingAll(true);
  SoBaseKit::setSearchingChildren(true);
  find.apply(bench.session->root());
  SoBaseKit::setSearchingChildren(false);
  REQUIRE(find.getPath());
  SoGetBoundingBoxAction measure(bench.viewport);
  measure.apply(find.getPath());
  const SbVec3f centre = measure.getBoundingBox().getCenter();
  const SbVec2s at = bench.session->pixelOf({centre[0], centre[1], centre[2]}, bench.viewport);
  bench.drag(at, {short(at[0] + 40), short(at[1] + 30)});

  CHECK(drag.begun == 1);
  CHECK(strayed < 1e-6);
  CHECK(bench.tools().pose(2).rotation.angularDistance(before.rotation) < 1e-3);
  CHECK(transform->scaleFactor.getValue().equals(SbVec3f(1, 1, 1), 1e-8f));
  const Vec3 after = bench.session->middleOfTool(2);
  CHECK((after - middle).norm() < 1e-5);
}

TEST_CASE(
    "with Shift the wheel and the page keys roll the tool in hand, with Ctrl the wheel zooms") {
  OperatingBench bench;
  REQUIRE(bench.key(SoKeyboardEvent::NUMBER_1));
  const Pose before = bench.tools().pose(0);
  bench.button({400, 250}, true, SoMouseButtonEvent::BUTTON4, true);
  const Pose rolled = bench.tools().pose(0);
  CHECK(rolled.rotation.angularDistance(before.rotation) == doctest::Approx(0.05).epsilon(0.02));
  CHECK((rolled.position - before.position).norm() < 1e-6);
  CHECK(bench.key(SoKeyboardEvent::PAGE_DOWN, true));
  CHECK(bench.tools().pose(0).rotation.angularDistance(before.rotation) < 1e-3);  // and back

  auto* camera = bench.session->room().camera();
  const float far = camera->focalDistance.getValue();
  bench.button({400, 250}, true, SoMouseButtonEvent::BUTTON4, false, true);
  CHECK(camera->focalDistance.getValue() < far);
  CHECK((bench.tools().pose(0).position - before.position).norm() < 1e-6);
}

TEST_CASE(
    "every named view has the organ in its middle part, and all comes into view from any side") {
  OperatingBench bench;
  const Aabb box = bench.session->cells().lattice.box();
  std::vector<SbVec3f> places;
  for (const RoomView view :
       {RoomView::Surgeon, RoomView::Assistant, RoomView::Top, RoomView::Laparoscope}) {
    bench.session->look(view, 1.6);
    const SbVec2s middle = bench.session->pixelOf(box.centre(), bench.viewport);
    CHECK(std::abs(middle[0] - 400) < 250);
    CHECK(std::abs(middle[1] - 250) < 150);
    for (const SbVec3f& other : places)
      CHECK((bench.session->room().camera()->position.getValue() - other).length() > 0.1f);
    places.push_back(bench.session->room().camera()->position.getValue());
  }
  // From close by and from the side.
  bench.drag({300, 300}, {500, 330}, SoMouseButtonEvent::BUTTON3);
  for (int i = 0; i < 10; ++i) bench.button({400, 250}, true, SoMouseButtonEvent::BUTTON4);
  const SbRotation side = bench.session->room().camera()->orientation.getValue();
  bench.session->viewAll(1.6);
  CHECK(bench.session->room().camera()->orientation.getValue().equals(side, 1e-6f));
  for (int tool = 0; tool < bench.tools().toolCount(); ++tool) {
    const SbVec2s at = bench.pixelOf(tool);
    CHECK(at[0] > 0);
    CHECK(at[0] < 800);
    CHECK(at[1] > 0);
    CHECK(at[1] < 500);
  }
}

TEST_CASE("the camera turns to the point that was clicked and keeps it in its middle") {
  OperatingBench bench;
  const Vec3 point = bench.pointOfOrgan();
  bench.session->camera().lookAt(point);
  CHECK((bench.session->camera().pointOfInterest() - point).norm() < 1e-3);
  const SbVec2s at = bench.session->pixelOf(point, bench.viewport);
  CHECK(std::abs(at[0] - 400) <= 2);
  CHECK(std::abs(at[1] - 250) <= 2);
  bench.drag({300, 300}, {360, 320}, SoMouseButtonEvent::BUTTON3);
  const SbVec2s after = bench.session->pixelOf(point, bench.viewport);
  CHECK(std::abs(after[0] - 400) <= 2);
}

TEST_CASE("a manipulator round a tool that is turned any way comes to rest") {
  OperatingBench bench;
  Random random(5);
  int changes = 0;
  const auto follow = bench.tools().changed;
  bench.tools().changed = [&] {
    REQUIRE(++changes < 100000);  // rounding must not keep it busy for ever
    follow();
  };
  for (int i = 0; i < 60; ++i) {
    const Vec3 axis = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    bench.tools().setPose(
        i % 3, {Vec3(random.uniform(-0.1, 0.1), 0.3, random.uniform(-0.1, 0.1)),
                Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0, 3), axis.normalized()))});
    for (const auto how : {ToolHandling::Hold::HandleBox, ToolHandling::Hold::Trackball}) {
      bench.tools().hold(i % 3, how);
      const Pose before = bench.tools().pose(i % 3);
      auto* transform = bench.session->room().toolTransform(i % 3);
      transform->translation.touch();
      transform->rotation.touch();
      bench.session->update();
      CHECK((bench.tools().pose(i % 3).position - before.position).norm() < 1e-5);
      CHECK(bench.tools().pose(i % 3).rotation.angularDistance(before.rotation) < 1e-3);
    }
  }
}
