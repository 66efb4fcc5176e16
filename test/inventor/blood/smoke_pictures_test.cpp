// Pictures of smoke, of a clip and of a bare vessel.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/primitives.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"
#include "inventor/scene/operation_view.h"
#include "io/operation_setup.h"
#include "operation/blood/bare_vessels.h"
#include "operation/blood/vessel_walls.h"
#include "operation/smoke/smoke_plume.h"

using namespace resect;

namespace {

constexpr int kSmokeWidth = 320, kSmokeHeight = 180;

struct Change {
  int pixels = 0;
  double x = 0, y = 0;                  // middle of what differs, pixels
  std::array<double, 3> was{}, mean{};  // colours there in the two pictures
};

Change change(const RgbImage& before, const RgbImage& after) {
  Change found;
  for (int y = 0; y < kSmokeHeight; ++y)
    for (int x = 0; x < kSmokeWidth; ++x) {
      int off = 0;
      for (int c = 0; c < 3; ++c)
        off = std::max(off, std::abs(int(before.at(x, y)[c]) - int(after.at(x, y)[c])));
      if (off < 6) continue;
      ++found.pixels, found.x += x, found.y += y;
      for (int c = 0; c < 3; ++c) {
        found.was[std::size_t(c)] += before.at(x, y)[c];
        found.mean[std::size_t(c)] += after.at(x, y)[c];
      }
    }
  const double n = std::max(1, found.pixels);
  found.x /= n, found.y /= n;
  for (auto* colour : {&found.was, &found.mean})
    for (double& m : *colour) m /= n;
  return found;
}

// A ball of 7 cm on a table, seen from above.
struct SmokeTable {
  OperatingRoom room;
  OffscreenView view{kSmokeWidth, kSmokeHeight};

  SmokeTable() {
    const Aabb box{{-0.15, 0, -0.15}, {0.15, 0.14, 0.15}};
    room.setTable(makeModel(boxMesh({{-0.6, -0.02, -0.6}, {0.6, 0, 0.6}})));
    room.setOrgan(sphereMesh({0, 0.07, 0}, 0.07, 24));
    room.lightUp(box);
    room.look(RoomView::Top, box, double(kSmokeWidth) / kSmokeHeight);
  }
  RgbImage draw() { return view.render(room.root()); }
};

std::vector<SmokeBall> puff(float x, float density) {
  return {SmokeBall{Vec3f(x, 0.15f, 0), 0.012f, density}};
}

}  // namespace

TEST_CASE(
    "smoke is a grey veil where it is, denser smoke hides more, and what is gone leaves no trace") {
  SmokeTable bench;
  const RgbImage clear = bench.draw();
  bench.room.setSmoke(puff(0.02f, 0.35f));
  const RgbImage smoky = bench.draw();
  const Change right = change(clear, smoky);
  REQUIRE(right.pixels > 30);
  CHECK(right.x > kSmokeWidth / 2 + 4);
  CHECK(std::abs(right.y - kSmokeHeight / 2) < 6);
  CHECK(right.mean[2] / right.mean[0] > 1.1 * right.was[2] / right.was[0]);  // less red
  bench.room.setSmoke(puff(-0.02f, 0.35f));
  CHECK(change(clear, bench.draw()).x < kSmokeWidth / 2 - 4);
  bench.room.setSmoke(puff(0.02f, 0.10f));
  CHECK(change(clear, bench.draw()).pixels < right.pixels);
  bench.room.setSmoke({});
  CHECK(bench.draw().pixels == clear.pixels);
}

TEST_CASE("what is in front of smoke hides it") {
  SmokeTable bench;
  const RgbImage clear = bench.draw();
  bench.room.setSmoke({SmokeBall{Vec3f(0, 0.05f, 0), 0.012f, 0.35f}});  // inside the organ
  CHECK(change(clear, bench.draw()).pixels == 0);
}

TEST_CASE("an operation shows the smoke of its steps for a while, thesis mode shows none") {
  for (const OperationMode mode : {OperationMode::Operation, OperationMode::Thesis}) {
    Scenario scenario;
    scenario.mode = mode;
    scenario.setting = "table";
    scenario.organs[0].source.spacing = 0.02;
    Simulation simulation = makeSimulation(scenario, &readModel);
    OperationView view(scenario, simulation, double(kSmokeWidth) / kSmokeHeight);
    OffscreenView screen(kSmokeWidth, kSmokeHeight);
    const RgbImage clear = view.draw(screen);
    StepReport report;
    const Aabb box = simulation.organ().rest.lattice.box();
    const auto pass = [&](int frames, bool burns) {
      report.smoke.clear();
      if (burns)
        report.smoke.push_back(
            {0, 0, Vec3(box.centre().x(), box.max.y() + 0.02, box.max.z()), 2e-5});
      for (int i = 0; i < frames; ++i) {
        report.time += 1 / 60.0;
        view.followSmoke(report);
      }
    };
    pass(10, false);
    CHECK(view.draw(screen).pixels == clear.pixels);
    pass(40, true);
    const Change first = change(clear, view.draw(screen));
    CHECK((first.pixels > 20) == (mode == OperationMode::Operation));
    pass(20, false);
    const Change risen = change(clear, view.draw(screen));
    if (mode == OperationMode::Operation) CHECK(risen.y < first.y - 2);
    pass(180, false);
    CHECK(view.draw(screen).pixels == clear.pixels);
  }
}

TEST_CASE(
    "a clip is grey steel at its place, a vein is bluish and a duct greenish beside an artery") {
  SmokeTable bench;
  const RgbImage none = bench.draw();
  BareVessels vessels;
  addClip(vessels.clips, vessels.clipNormals, Vec3(0.03, 0.142, 0), Vec3::UnitX(), Vec3::UnitZ(),
          0.010);
  bench.room.setBareVessels(&vessels);
  const Change clip = change(none, bench.draw());
  REQUIRE(clip.pixels > 10);
  CHECK(clip.x > kSmokeWidth / 2 + 6);
  CHECK(std::abs(clip.y - kSmokeHeight / 2) < 5);
  CHECK(clip.mean[0] < 1.7 * clip.mean[2]);
  std::array<Change, kVesselKinds> seen;
  for (int kind = 0; kind < kVesselKinds; ++kind) {
    BareVessels bare;
    VesselWall wall;
    wall.kind = VesselKind(kind);
    wall.lumen = 0.0045;
    wall.outside = wall.outsideA = wall.outsideB = 0.005;
    wall.present = {Vec3(-0.04, 0.146, 0), Vec3(0.04, 0.146, 0), Vec3(0.08, 0, 0),
                    Vec3(0.08, 0, 0)};
    wall.rest = wall.present;
    addWall(bare.walls, wall);
    bench.room.setBareVessels(&bare);
    seen[std::size_t(kind)] = change(none, bench.draw());
    CHECK(seen[std::size_t(kind)].pixels > 100);
  }
  const auto& [portal, hepatic, artery, duct] = seen;
  const auto share = [](const Change& c, int a, int b) {
    return c.mean[std::size_t(a)] / c.mean[std::size_t(b)];
  };
  CHECK(share(portal, 2, 0) > share(artery, 2, 0));
  CHECK(share(hepatic, 2, 1) > share(duct, 2, 1));
  CHECK(share(duct, 1, 0) > 1.15 * share(artery, 1, 0));
  CHECK(hepatic.mean[1] < 0.8 * artery.mean[1]);
  bench.room.setBareVessels(nullptr);
  CHECK(bench.draw().pixels == none.pixels);
}
