// What a person sees first, and what stays where it is while the camera moves.
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/nodekits/SoBaseKit.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>
#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "geometry/rotation.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/SoShadowMaps.h"
#include "inventor/init.h"
#include "inventor/picture/offscreen_view.h"
#include "support/operating_bench.h"

using namespace resect;
using test::OperatingBench;

namespace {

// Share of the pixels that show the liver: no other thing in the room is that red.
double redShare(const RgbImage& picture) {
  std::size_t red = 0;
  for (std::size_t p = 0; p < picture.pixels.size(); p += 3)
    red += picture.pixels[p] > 24 && picture.pixels[p] > 1.6 * picture.pixels[p + 1];
  return 3.0 * double(red) / double(picture.pixels.size());
}

bool holdsDragger(SoNode* root) {
  SoSearchAction search;
  search.setType(SoDragger::getClassTypeId());
  search.setSearchingAll(TRUE);
  SoBaseKit::setSearchingChildren(TRUE);
  search.apply(root);
  SoBaseKit::setSearchingChildren(FALSE);
  return search.getPath() != nullptr;
}

}  // namespace

TEST_CASE("the surgeon's view is a close-up: the organ fills about half of the picture") {
  for (const double turned : {0.0, 0.7})
    for (const auto& [width, height] :
         {std::pair(320, 320), std::pair(480, 270), std::pair(270, 480)}) {
      Scenario scenario;
      scenario.mode = OperationMode::Operation;
      scenario.organs[0].source.spacing = 0.012;
      scenario.organs[0].source.pose.rotation = rotationAbout(Vec3::UnitY(), turned);
      const ModelReader reader = [](const std::filesystem::path& p, const std::string& parts) {
        return readModel(p, parts);
      };
      const double aspect = double(width) / height;
      OperatingSession session(
          scenario, std::make_unique<Simulation>(makeSimulation(scenario, reader)), aspect);
      session.showScale(false);
      session.look(RoomView::Surgeon, aspect);
      OffscreenView view(width, height, 1);
      const double share = redShare(view.render(session.root()));
      INFO("turned ", turned, ", picture ", width, " x ", height, ": ", share);
      CHECK(share > 0.33);
      CHECK(share < 0.60);
    }
}

TEST_CASE("the wheel brings the camera to what is under the pointer, which stays there") {
  OperatingBench bench;
  bench.session->look(RoomView::Assistant, 1.6);
  const SbVec2s middle =
      bench.session->pixelOf(bench.session->cells().lattice.box().centre(), bench.viewport);
  for (const SbVec2s& aside : {SbVec2s(0, 0), SbVec2s(60, 30), SbVec2s(-200, -120)}) {
    const SbVec2s at = middle + aside;
    const auto under = bench.session->pointUnder(at, bench.viewport);
    REQUIRE(under);
    const auto far = [&] {
      const float* p = bench.session->room().camera()->position.getValue().getValue();
      return (Vec3(p[0], p[1], p[2]) - under->point).norm();
    };
    const double before = far();
    for (const auto wheel : {SoMouseButtonEvent::BUTTON4, SoMouseButtonEvent::BUTTON5}) {
      for (int i = 0; i < 6; ++i) bench.button(at, true, wheel);
      const SbVec2s now = bench.session->pixelOf(under->point, bench.viewport);
      CHECK(std::abs(now[0] - at[0]) <= 1);
      CHECK(std::abs(now[1] - at[1]) <= 1);
      CHECK((wheel == SoMouseButtonEvent::BUTTON4
                 ? far() < 0.5 * before
                 : far() == doctest::Approx(before).epsilon(0.01)));
    }
  }
}

TEST_CASE("in the field the camera stays above the abdominal wall, on the table it may go lower") {
  OperatingBench bench(true);
  const auto height = [&] {
    bench.session->camera().orbit(0, 4);
    const float* p = bench.session->room().camera()->position.getValue().getValue();
    const Vec3 away = Vec3(p[0], p[1], p[2]) - bench.session->camera().pointOfInterest();
    return std::asin(away.y() / away.norm());
  };
  CHECK(height() == doctest::Approx(-0.2).epsilon(0.01));
  bench.session->showField(true);
  for (const double turned : {0.0, 1.5, 3.0}) {
    bench.session->camera().orbit(turned, 0);
    CHECK(height() == doctest::Approx(0.35).epsilon(0.01));
  }
}

TEST_CASE("the scale stands beside the organ in every view, and can be hidden") {
  OperatingBench bench;
  for (int i = 0; i < 24; ++i) {
    bench.session->camera().orbit(0.27, i % 2 ? 0.05 : -0.05);
    bench.button({400, 250}, true, SoMouseButtonEvent::BUTTON5, false,
                 true);  // moves the scale too
    const Vec3 foot = bench.session->iso().handle();
    const SbVec2s at = bench.session->pixelOf(foot, bench.viewport);
    const auto under = bench.session->pointUnder(at, bench.viewport);
    const Aabb organ = bench.session->cells().lattice.box();
    if (under) CHECK_FALSE((under->point.y() > 0.003 && organ.contains(under->point)));
  }
  bench.session->look(RoomView::Surgeon, 1.6);
  const SbVec2s at = bench.session->pixelOf(bench.session->iso().handle(), bench.viewport);
  const SbVec2s above(at[0], short(at[1] + 25));
  bench.session->showScale(false);
  bench.drag(at, above);
  CHECK(bench.session->iso().value() == 50);
  bench.session->showScale(true);
  bench.session->look(RoomView::Surgeon, 1.6);
  bench.drag(at, above);
  CHECK(bench.session->iso().value() > 55);
}

TEST_CASE("a trackball casts no shadow, and the shadow of its instrument follows it") {
  OperatingBench bench;
  bench.tools().hold(2, ToolHandling::Hold::Trackball);
  bench.settle();
  OperatingRoom& room = bench.session->room();
  SoNode* movers = room.shadows().movers.getValue();
  CHECK(holdsDragger(room.root()));
  CHECK_FALSE(holdsDragger(movers));
  const SbVec2s on = bench.pixelOf(2);
  bench.drag(on, {short(on[0] + 50), short(on[1] + 30)});
  const auto* tool = static_cast<SoSeparator*>(static_cast<SoSeparator*>(movers)->getChild(2));
  const auto* shadow = static_cast<SoTransform*>(tool->getChild(0));
  const Pose pose = bench.tools().pose(2), cast = getPose(*shadow);
  CHECK(cast.rotation.angularDistance(pose.rotation) < 1e-4);
  CHECK((cast.position - pose.position).norm() < 1e-6);
}

TEST_CASE("tissue that creeps is slow, tissue that is pulled or cut is not") {
  initInventor();
  auto* shape = new SoOrganShape;
  shape->ref();
  std::vector<Vec3f> points(200, Vec3f::Zero());
  const std::vector<Vec3f> normals(200, Vec3f::UnitY());
  const std::vector<Triangle> triangles{{0, 70, 150}};
  shape->update(wholeSurface(points, normals, std::vector<float>(200), triangles));
  CHECK(std::isinf(shape->takeSpeed()));
  const auto moved = [&](float way) {
    for (Vec3f& p : points) p.y() += way;
    SurfaceUpdate update;
    addMovedVertices(update, {0, 200}, points, normals);
    shape->update(update);
    return shape->takeSpeed();
  };
  moved(1e-5f);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  CHECK(moved(5e-5f) < 6e-4);
  CHECK(shape->takeSpeed() == 0);
  CHECK(moved(1e-2f) > 0.05);
  SurfaceUpdate cut;
  addNewTriangles(cut, {0, 1}, triangles);
  shape->update(cut);
  CHECK(std::isinf(shape->takeSpeed()));
  shape->unref();
}
