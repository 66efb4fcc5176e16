// The operative field round the organs: what is drawn, what is hidden, and the way back to the
// table.
#include <Inventor/nodes/SoSeparator.h>
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "geometry/rotation.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operation_view.h"
#include "io/operation_setup.h"
#include "operation/room.h"

using namespace resect;

namespace {

constexpr int kAbdomenWidth = 320, kAbdomenHeight = 200;

struct AbdomenView {
  Scenario scenario;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<OperationView> view;
  OffscreenView screen{kAbdomenWidth, kAbdomenHeight, 1};

  explicit AbdomenView(const std::string& setting, const std::string& from = "surgeon",
                       double turned = 0, OperationMode mode = OperationMode::Operation) {
    scenario.mode = mode;
    scenario.organs[0].source.spacing = 0.015;
    scenario.organs[0].source.pose.rotation = rotationAbout(Vec3::UnitY(), turned);
    scenario.tools.push_back({"scalpel", {}, toolBoxPlace(0), {}});
    scenario.setting = setting;
    scenario.view = from;
    simulation = std::make_unique<Simulation>(makeSimulation(scenario, &readModel));
    view = std::make_unique<OperationView>(scenario, *simulation,
                                           double(kAbdomenWidth) / kAbdomenHeight);
  }
  RgbImage draw() { return view->draw(screen); }
};

struct Shares {
  double green = 0, yellow = 0, red = 0, black = 0;  // of the picture's pixels
};

Shares shares(const RgbImage& picture) {
  Shares found;
  const double one = 3.0 / double(picture.pixels.size());
  for (std::size_t p = 0; p < picture.pixels.size(); p += 3) {
    const double r = picture.pixels[p], g = picture.pixels[p + 1], b = picture.pixels[p + 2];
    if (r + g + b < 24) found.black += one;
    if (g > 1.2 * r && g > 20) found.green += one;
    if (r > 60 && g > 0.55 * r && b < 0.62 * g) found.yellow += one;
    if (r > 30 && r > 1.6 * g) found.red += one;
  }
  return found;
}

int differing(const RgbImage& a, const RgbImage& b) {
  int pixels = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3)
    pixels += !std::equal(&a.pixels[i], &a.pixels[i] + 3, &b.pixels[i]);
  return pixels;
}

}  // namespace

TEST_CASE("in the operative field drapes fill the picture round an opening with fat and bowel") {
  for (const double turned : {0.0, 0.9}) {
    const Shares table = shares(AbdomenView("table", "top", turned).draw());
    const Shares field = shares(AbdomenView("field", "top", turned).draw());
    INFO("turned ", turned, ": green ", field.green, ", yellow ", field.yellow, ", red ", field.red,
         ", black ", field.black);
    CHECK(table.yellow < 0.002);
    CHECK(field.yellow > 0.04);
    CHECK(field.green > 0.25);
    CHECK(field.red > 1.3 * table.red);  // the bed of the liver, stomach and bowel
    CHECK(field.black < 0.02);           // nothing is left open between the layers
  }
}

TEST_CASE("the operative field has a part for every shader, and no part without one") {
  const auto* parts = static_cast<SoSeparator*>(readRoomModel("field"));
  parts->ref();
  std::set<std::string> names;
  for (int i = 0; i < parts->getNumChildren(); ++i)
    names.insert(parts->getChild(i)->getName().getString());
  CHECK(names ==
        std::set<std::string>{"drape", "skin", "fat", "muscle", "omentum", "gut", "steel", "dome"});
  parts->unref();
}

TEST_CASE("in the field an instrument is seen in a hand, and not while it is at rest") {
  AbdomenView bench("field", "top");
  OperatingRoom& room = bench.view->room();
  const RgbImage resting = bench.draw();
  const Vec3 over = bench.simulation->organ().rest.lattice.box().centre() + Vec3(0, 0.12, 0);
  room.setToolPose(0, {over, workingRotation()});
  room.changedIn({});
  CHECK(differing(resting, bench.draw()) > 200);
  room.setToolPose(0, bench.scenario.tools[0].rest);
  room.changedIn({});
  CHECK(differing(resting, bench.draw()) == 0);
}

TEST_CASE("after the field the table is as it was, with the instruments on it") {
  AbdomenView bench("table");
  const RgbImage before = bench.draw();
  bench.view->showField(true);
  bench.view->room().changedIn({});
  CHECK(differing(before, bench.draw()) > kAbdomenWidth * kAbdomenHeight / 3);
  bench.view->showField(false);
  bench.view->room().changedIn({});
  CHECK(differing(before, bench.draw()) == 0);
}

TEST_CASE("thesis mode has the table in any setting") {
  const RgbImage table = AbdomenView("table", "surgeon", 0, OperationMode::Thesis).draw();
  CHECK(differing(table, AbdomenView("field", "surgeon", 0, OperationMode::Thesis).draw()) == 0);
}

TEST_CASE("a laparoscope's picture is round, by its own light, below a closed wall") {
  for (const char* setting : {"table", "field"}) {
    AbdomenView bench(setting);
    OperatingRoom& room = bench.view->room();
    const Aabb box = bench.simulation->organ().rest.lattice.box();
    room.look(RoomView::Laparoscope, box, double(kAbdomenWidth) / kAbdomenHeight);
    const RgbImage scope = bench.draw();
    for (const auto& [x, y] :
         {std::pair(2, 2), std::pair(kAbdomenWidth - 3, 2), std::pair(2, kAbdomenHeight - 3),
          std::pair(kAbdomenWidth - 3, kAbdomenHeight - 3), std::pair(40, kAbdomenHeight / 2)})
      for (int c = 0; c < 3; ++c) CHECK(scope.at(x, y)[c] == 0);
    const Shares seen = shares(scope);
    const double round = 3.14159 * 0.25 * 0.97 * 0.97 * kAbdomenHeight / kAbdomenWidth;
    CHECK(1 - seen.black < 1.02 * round);
    if (bench.scenario.setting == "field") {
      CHECK(1 - seen.black > 0.95 * round);  // the wall closes the picture
      CHECK(seen.green < 0.01);              // no drapes
      CHECK(seen.yellow > 0.02);
    }
    CHECK(seen.red > 0.08);
    // The surgeon's view is again as it was.
    AbdomenView other(setting);
    room.look(RoomView::Surgeon, box, double(kAbdomenWidth) / kAbdomenHeight);
    other.view->room().look(RoomView::Surgeon, box, double(kAbdomenWidth) / kAbdomenHeight);
    CHECK(differing(bench.draw(), other.draw()) == 0);
  }
}
