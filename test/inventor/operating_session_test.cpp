#include "inventor/hand/operating_session.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <chrono>
#include <thread>

#include <doctest/doctest.h>

#include "inventor/gl/SoOrganShape.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/scenario/scenario_file.h"
#include "operation/room.h"
#include "operation/run.h"
#include "support/operating_bench.h"
#include "support/references/nearest_triangle.h"

using namespace resect;
using test::OperatingBench;

TEST_CASE("a click on each tool attaches a handle box, a middle click toggles, elsewhere lets go") {
  OperatingBench bench;
  for (int tool = 0; tool < bench.tools().toolCount(); ++tool) {
    CAPTURE(tool);
    const Pose before = bench.tools().pose(tool);
    bench.click(bench.pixelOf(tool));
    REQUIRE(bench.tools().held() == tool);
    CHECK(bench.tools().how() == ToolHandling::Hold::HandleBox);
    CHECK(bench.manipulated(tool));
    bench.click(bench.pixelOf(tool), SoMouseButtonEvent::BUTTON2);
    CHECK(bench.tools().how() == ToolHandling::Hold::Trackball);
    bench.click(bench.pixelOf(tool), SoMouseButtonEvent::BUTTON2);
    CHECK(bench.tools().how() == ToolHandling::Hold::HandleBox);
    bench.click(bench.nowhere());
    CHECK(bench.tools().held() == -1);
    CHECK_FALSE(bench.manipulated(tool));
    CHECK((bench.tools().pose(tool).position - before.position).norm() < 1e-6);
    CHECK(bench.tools().pose(tool).rotation.angularDistance(before.rotation) < 1e-3);
  }
}

TEST_CASE("dragging a tool moves it under the pointer; with Shift it turns about its tip") {
  OperatingBench bench;
  const SbVec2s from = bench.pixelOf(0), to(short(from[0] - 120), short(from[1] + 90));
  bench.drag(from, to);
  REQUIRE(bench.tools().held() == 0);
  CHECK(bench.tools().how() == ToolHandling::Hold::Direct);
  const SbVec2s tip = bench.session->pixelOf(bench.tools().pose(0).position, bench.viewport);
  CHECK(std::abs(tip[0] - to[0]) < 12);
  CHECK(std::abs(tip[1] - to[1]) < 12);

  const Pose before = bench.tools().pose(0);
  bench.drag({400, 300}, {460, 300}, SoMouseButtonEvent::BUTTON1, true);
  CHECK((bench.tools().pose(0).position - before.position).norm() < 1e-6);
  CHECK(bench.tools().pose(0).rotation.angularDistance(before.rotation) > 0.1);
}

TEST_CASE("a pick hits what is under the pointer in pictures of any shape") {
  OperatingBench bench;
  for (const SbVec2s size : {SbVec2s(900, 300), SbVec2s(500, 500), SbVec2s(450, 700)}) {
    CAPTURE(size[0]);
    bench.viewport = SbViewportRegion(size);
    bench.session->bringEverythingBack(double(size[0]) / size[1]);
    for (int tool = 0; tool < bench.tools().toolCount(); ++tool) {
      bench.click(bench.pixelOf(tool));
      CHECK(bench.tools().held() == tool);
      bench.tools().hold(-1, ToolHandling::Hold::None);
    }
  }
}

TEST_CASE("no tool goes through the table") {
  OperatingBench bench;
  bench.tools().take(0);
  bench.tools().setPose(0, {Vec3(0.3, -0.2, 0.3), bench.tools().pose(0).rotation});
  double lowest = 1;
  for (const Vec3& p : bench.session->toolModels()[0].mesh.points)
    lowest = std::min(lowest, (bench.tools().pose(0) * p).y());
  CHECK(lowest == doctest::Approx(0).epsilon(1e-6));
}

TEST_CASE(
    "a moved tool damages its own pixels and its shadow's, a moved camera the whole picture") {
  OperatingBench bench;
  bench.tools().take(0);
  bench.session->update();
  bench.settle();
  bench.session->update();
  bench.tools().move({0.002, 0, 0});
  const Damage damage = bench.session->update();
  const auto& camera = *bench.session->room().camera();
  const std::vector<PixelRect> parts = pixelsOf(damage, camera, bench.viewport);
  CHECK_FALSE(damage.everything);
  CHECK(area(parts) > 500);
  CHECK(area(parts) < 800 * 500 / 2);
  const SbVec2s tool = bench.pixelOf(0);
  CHECK(std::any_of(parts.begin(), parts.end(), [&](const PixelRect& part) {
    return part.left < tool[0] && part.right > tool[0] && part.bottom < tool[1] &&
           part.top > tool[1];
  }));
  bench.session->camera().orbit(0.1, 0);
  bench.session->look(RoomView::Surgeon, 1.6);
  CHECK(area(pixelsOf(bench.session->update(), camera, bench.viewport)) == 800 * 500);
}

TEST_CASE("wheel and keys move the tool in hand, in depth and in the view; Escape puts it back") {
  OperatingBench bench;
  const Pose rest = bench.tools().pose(1);
  REQUIRE(bench.key(SoKeyboardEvent::NUMBER_2));
  REQUIRE(bench.tools().held() == 1);
  const Vec3 camera = [&] {
    const SbVec3f p = bench.session->room().camera()->position.getValue();
    return Vec3(p[0], p[1], p[2]);
  }();
  const double before = (bench.tools().pose(1).position - camera).norm();
  bench.button({400, 250}, true, SoMouseButtonEvent::BUTTON4);
  const double after = (bench.tools().pose(1).position - camera).norm();
  CHECK(after > before + 0.003);
  const Vec3 position = bench.tools().pose(1).position;
  for (const auto key :
       {SoKeyboardEvent::LEFT_ARROW, SoKeyboardEvent::UP_ARROW, SoKeyboardEvent::PAGE_UP,
        SoKeyboardEvent::RIGHT_ARROW, SoKeyboardEvent::DOWN_ARROW, SoKeyboardEvent::PAGE_DOWN})
    CHECK(bench.key(key));
  CHECK((bench.tools().pose(1).position - position).norm() < 1e-6);  // there and back
  bench.key(SoKeyboardEvent::LEFT_ARROW, true);
  CHECK(bench.tools().pose(1).rotation.angularDistance(rest.rotation) > 0.04);
  CHECK(bench.key(SoKeyboardEvent::ESCAPE));
  CHECK(bench.tools().held() == -1);
  CHECK((bench.tools().pose(1).position - rest.position).norm() < 1e-6);
  CHECK_FALSE(bench.key(SoKeyboardEvent::ESCAPE));
  CHECK_FALSE(bench.key(SoKeyboardEvent::NUMBER_9));
}

TEST_CASE("a tool that is held cuts, one that lies in the tissue does not") {
  OperatingBench bench;
  const Vec3 inside = bench.session->cells().lattice.box().centre();
  bench.tools().setPose(2, {inside + Vec3(0, 0.02, 0), Eigen::Quaterniond::Identity()});
  bench.settle();
  CHECK(bench.session->state().removed == 0);
  const int before = bench.session->room().organ()->triangleCount();
  bench.tools().hold(2, ToolHandling::Hold::Direct);
  bench.tools().setPose(2, {inside, Eigen::Quaterniond::Identity()});
  bench.settle();
  CHECK(bench.session->state().removed > 0);
  CHECK(bench.session->state().touching[2] == 1);
  CHECK(bench.session->state().tips[2].distance == doctest::Approx(0).epsilon(0.03));
  CHECK(bench.session->room().organ()->triangleCount() >= before);
}

TEST_CASE("a stroke is taken back with the tool where it was, and done again") {
  OperatingBench bench;
  const Vec3 inside = bench.session->cells().lattice.box().centre();
  bench.tools().hold(2, ToolHandling::Hold::Direct);
  for (int i = 0; i <= 12; ++i) {
    bench.tools().setPose(2,
                          {inside + Vec3(0, 0.15 - 0.0125 * i, 0), Eigen::Quaterniond::Identity()});
    bench.settle();
  }
  const std::int64_t removed = bench.session->state().removed;
  REQUIRE(removed > 0);
  REQUIRE(bench.session->state().undoable == 1);
  const Vec3 end = bench.tools().pose(2).position;
  bench.session->undo();
  bench.settle();
  bench.settle();
  CHECK(bench.session->state().removed == 0);
  CHECK(bench.session->state().redoable == 1);
  CHECK(bench.tools().held() == 2);
  CHECK((bench.tools().pose(2).position - end).norm() > 0.02);
  // The moment stays until the hand moves.
  const std::int64_t frame = bench.session->state().frame;
  CHECK(bench.session->showing());
  for (int i = 0; i < 5; ++i) bench.settle();
  CHECK(bench.session->state().frame == frame);
  bench.session->redo();
  bench.settle();
  bench.settle();
  CHECK(bench.session->state().removed == removed);
  CHECK((bench.tools().pose(2).position - end).norm() < 0.013);
  CHECK(bench.session->state().timeline->courses.size() == 1);
  // From an earlier moment the hand goes on in another branch.
  bench.session->show({0, frame});
  bench.settle();
  CHECK(bench.session->state().removed == 0);
  bench.tools().setPose(2, {inside, Eigen::Quaterniond::Identity()});
  CHECK_FALSE(bench.session->showing());
  bench.settle();
  bench.settle();
  CHECK(bench.session->state().removed > 0);
  CHECK(bench.session->state().moment.branch == 1);
  CHECK(bench.session->state().timeline->courses.size() == 2);
}

TEST_CASE("what was recorded plays again, as fast as is asked for, and stands at its end") {
  OperatingBench bench;
  for (int i = 0; i < 10; ++i) bench.settle();
  const std::int64_t end = bench.session->state().frame;
  bench.session->show({0, 2});
  bench.settle();
  CHECK(bench.session->state().frame == 2);
  bench.session->setPlayback(4, 0);
  for (int i = 0; i < 500 && bench.session->state().frame < end; ++i) {
    bench.session->operation().waitFor(bench.session->state().frame + 1);
    bench.session->update();
  }
  CHECK(bench.session->state().frame >= end);
  CHECK(bench.session->showing());
  bench.session->goOn();
  bench.settle();
  CHECK_FALSE(bench.session->state().showing);
  CHECK(bench.session->state().moment.branch == 0);
  // A branch gets another name, also while a moment is shown.
  bench.session->show({0, 3});
  bench.settle();
  bench.session->operation().nameBranch(0, "the first way");
  for (int i = 0; i < 200; ++i) {
    bench.session->update();
    if (bench.session->state().timeline->courses[0].branch.name == "the first way") break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  CHECK(bench.session->state().timeline->courses[0].branch.name == "the first way");
  CHECK(bench.session->state().frame == 3);
}

TEST_CASE("the picture gets the changed ranges of the surface and nothing else") {
  OperatingBench bench;
  auto* organ = bench.session->room().organ();
  const int revision = organ->revision.getValue();
  for (int i = 0; i < 5; ++i) bench.settle();
  CHECK(organ->revision.getValue() == revision);  // nothing happens, nothing is sent
}

TEST_CASE("dragging the iso scale changes the level and with it the surface") {
  OperatingBench bench;
  const auto before = bench.session->state().triangles;
  const SbVec2s at = bench.session->pixelOf(bench.session->iso().handle(), bench.viewport);
  bench.drag(at, {at[0], short(at[1] + 40)});
  CHECK(bench.session->iso().value() > 55);
  CHECK(bench.tools().held() == -1);
  bench.settle();
  CHECK(bench.session->state().iso == bench.session->iso().value());
  CHECK(bench.session->state().triangles != before);
}

TEST_CASE("the camera orbits, zooms and pans, and comes home") {
  OperatingBench bench;
  auto* camera = bench.session->room().camera();
  const SbVec3f home = camera->position.getValue();
  bench.drag({300, 300}, {360, 330}, SoMouseButtonEvent::BUTTON3);
  CHECK((camera->position.getValue() - home).length() > 0.02f);
  const float far = camera->focalDistance.getValue();
  bench.button({400, 250}, true, SoMouseButtonEvent::BUTTON4);
  CHECK(camera->focalDistance.getValue() < far);
  const Vec3 target = bench.session->camera().pointOfInterest();
  bench.drag({300, 300}, {340, 300}, SoMouseButtonEvent::BUTTON2);
  CHECK((bench.session->camera().pointOfInterest() - target).norm() > 0.005);
  bench.tools().setPose(0, {Vec3(0, 5, 0), Eigen::Quaterniond::Identity()});
  bench.session->bringEverythingBack(1.6);
  CHECK((camera->position.getValue() - home).length() < 1e-5f);
  CHECK((bench.tools().pose(0).position - toolBoxPlace(0).position).norm() < 1e-6);
}

TEST_CASE("a point of the organ is found under a pixel") {
  OperatingBench bench;
  CHECK(bench.session->cells().lattice.box().padded(0.01).contains(bench.pointOfOrgan()));
}

namespace {

// m: from the surface as the operation says that it is now.
double offSurface(OperatingSession& session, const Vec3& point) {
  const TriangleMesh mesh = session.operation().surface().mesh;
  return test::NearestTriangle(mesh, 0.01)(point).distance;
}

}  // namespace

TEST_CASE("where tissue was cut away the point under a pixel lies on the wound, not on what was") {
  OperatingBench bench;
  const auto whole = bench.session->operation().surface().mesh;
  const Vec3 before = bench.pointOfOrgan();
  CHECK(offSurface(*bench.session, before) < 1e-6);
  bench.tools().hold(2, ToolHandling::Hold::Direct);
  const Vec3 eye = [&] {
    const SbVec3f p = bench.session->room().camera()->position.getValue();
    return Vec3(p[0], p[1], p[2]);
  }();
  const Vec3 inwards = (before - eye).normalized();
  // Swept to and fro over what is seen there, deeper and deeper.
  for (int i = 0; i < 24; ++i) {
    const Vec3 aside(0.02 * (i % 2 ? 1 : -1), 0, 0);
    bench.tools().setPose(2, {before + aside + 0.001 * (i - 4) * inwards,
                              Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), -inwards)});
    bench.settle();
  }
  bench.tools().hold(-1, ToolHandling::Hold::None);
  bench.tools().putBack(2);
  bench.settle();
  REQUIRE(bench.session->state().removed > 0);
  const Vec3 now = bench.pointOfOrgan();
  CHECK(offSurface(*bench.session, now) < 1e-6);
  CHECK(test::NearestTriangle(whole, 0.01)(now).distance > 0.003);
  CHECK((now - before).dot(inwards) > 0.003);
  // Still under that pixel.
  const SbVec2s at = bench.session->pixelOf(before, bench.viewport);
  const SbVec2s seen = bench.session->pixelOf(now, bench.viewport);
  CHECK(std::abs(at[0] - seen[0]) <= 1);
  CHECK(std::abs(at[1] - seen[1]) <= 1);
}

TEST_CASE("where tissue has moved the point under a pixel lies on the surface as it is seen now") {
  Scenario scenario;
  scenario.organs[0].source.spacing = 0.016;
  makeElastic(scenario);
  int place = 0;
  for (const ToolKind& kind : toolKinds())
    if (!kind.stopsBleeding)
      scenario.tools.push_back({std::string(kind.name), {}, toolBoxPlace(place++), {}});
  const ModelReader reader = [](const std::filesystem::path& p, const std::string& parts) {
    return readModel(p, parts);
  };
  Organ organ =
      makeOrgan(loadCells(scenario.organs[0].source, reader), scenario.organs[0].source.settings);
  const TriangleMesh atRest = organ.surface.mesh();
  auto tissue = makeTissue(scenario.organs[0].tissue, organ);
  OperatingSession session(scenario,
                           std::make_unique<Simulation>(
                               std::move(organ), loadTools(scenario, reader), std::move(tissue)),
                           1.6);
  // It sinks under its own weight.
  session.operation().waitFor(90);
  session.operation().setPaused(true);
  session.operation().surface();  // the frame in work is over
  session.update();
  const SbViewportRegion viewport(800, 500);
  const Aabb box = session.cells().lattice.box();
  double moved = 0;
  for (int i = 0; i < 9; ++i) {
    const Vec3 through =
        box.centre() + 0.25 * Vec3((i % 3 - 1) * box.size().x(), 0, (i / 3 - 1) * box.size().z());
    const auto under = session.pointUnder(session.pixelOf(through, viewport), viewport);
    REQUIRE(under);
    const Vec3 point = under->point;
    if (point.y() < 1e-6) continue;  // the table
    // To within the motion that no eye sees.
    CHECK(offSurface(session, point) < 2e-4);
    moved = std::max(moved, test::NearestTriangle(atRest, 0.01)(point).distance);
  }
  CHECK(moved > 1e-3);
  session.operation().setPaused(false);
}

TEST_CASE(
    "beside the organ the point under a pixel lies on the table, and on the wall there is none") {
  OperatingBench bench;
  const Vec3 onTable(0, 0, bench.session->cells().lattice.box().max.z() + 0.03);
  const auto under =
      bench.session->pointUnder(bench.session->pixelOf(onTable, bench.viewport), bench.viewport);
  REQUIRE(under);
  CHECK(std::abs(under->point.y()) < 1e-6);
  CHECK((under->point - onTable).norm() < 0.005);  // some pixels
  // Level with the table's top and upwards there is nothing.
  auto* camera = bench.session->room().camera();
  camera->pointAt(camera->position.getValue() + SbVec3f(0, 0.2f, -1), SbVec3f(0, 1, 0));
  CHECK_FALSE(bench.session->pointUnder({400, 250}, bench.viewport));
}

TEST_CASE("C held down closes the scissors in hand, and they open again when it is let go") {
  OperatingBench bench;
  const auto squeeze = [&](std::int64_t frames) {
    bench.session->operation().waitFor(bench.session->state().frame + frames);
    bench.session->update();
    return bench.session->state().squeeze[3];
  };
  REQUIRE(bench.session->toolModels()[3].kind == "scissors");
  CHECK(bench.session->state().squeeze[3] == 1);  // they lie in the tool box closed
  const double closed = bench.session->room().toolBounds(3).size().norm();
  CHECK_FALSE(bench.key(SoKeyboardEvent::C));
  bench.tools().take(3);
  CHECK(squeeze(30) == 0);
  CHECK(bench.session->room().toolBounds(3).size().norm() > closed);
  CHECK(bench.key(SoKeyboardEvent::C));
  CHECK(squeeze(30) == 1);
  CHECK(bench.key(SoKeyboardEvent::C, false, false));
  CHECK(squeeze(30) == 0);
}

TEST_CASE("a 3D mouse moves and turns what is in hand, and the view when nothing is") {
  OperatingBench bench;
  bench.tools().take(0);
  const Pose before = bench.tools().pose(0);
  const SbVec3f eye = bench.session->room().camera()->position.getValue();
  bench.session->follow({Vec3(0.01, 0, 0), Vec3(0, 0.1, 0)});
  const Pose after = bench.tools().pose(0);
  CHECK((after.position - before.position).norm() == doctest::Approx(0.01));
  CHECK(after.rotation.angularDistance(before.rotation) == doctest::Approx(0.1));
  CHECK(bench.session->room().camera()->position.getValue() == eye);

  bench.tools().hold(-1, ToolHandling::Hold::None);
  bench.session->update();
  CHECK_FALSE(bench.session->pending());
  bench.session->follow({Vec3(0, 0, 0.05), Vec3::Zero()});
  CHECK(bench.session->pending());
  const SbVec3f farther = bench.session->room().camera()->position.getValue();
  CHECK((farther - eye).length() == doctest::Approx(0.05).epsilon(0.1));
  CHECK(bench.tools().pose(0).position == after.position);
}

TEST_CASE("a scenario that is played in the window removes what it removes without one") {
  Scenario scenario = readScenario(findDataFile("perforate-120", "scenarios", ".toml"));
  const ModelReader reader = [](const std::filesystem::path& p, const std::string& parts) {
    return readModel(p, parts);
  };
  const auto make = [&] {
    return std::make_unique<Simulation>(
        makeOrgan(loadCells(scenario.organs[0].source, reader), scenario.organs[0].source.settings),
        loadTools(scenario, reader));
  };
  scenario.duration = 2;
  auto simulation = make();
  const RunSummary expected = runScenario(*simulation, scenario);
  const std::int64_t expectedRemoved = expected.ledger.tissue().removed.particles;
  REQUIRE(expectedRemoved > 0);

  OperatingSession session(scenario, make(), 1.6);
  const auto playUntil = [&](double time) {
    session.play(time);
    while (session.playing()) {
      session.operation().waitFor(session.state().frame + 1);
      session.update();
    }
  };
  playUntil(1);
  CHECK(session.state().removed <= expectedRemoved);
  playUntil(1e9);
  CHECK(session.state().removed == expectedRemoved);
  CHECK((session.tools().pose(0).position - scenario.tools[0].rest.position).norm() < 1e-6);

  // Each time from the start of the operation, whatever was cut since.
  session.tools().take(0);
  // Particles lie between the box's centre and half a cell beside it.
  const Vec3 inside =
      session.cells().lattice.box().centre() + 0.5 * session.cells().lattice.spacing;
  for (int i = -5; i <= 5; ++i) {
    session.tools().setPose(0, {inside + Vec3(0.02 * i, 0, 0), Eigen::Quaterniond::Identity()});
    session.operation().waitFor(session.state().frame + 2);
    session.update();
  }
  REQUIRE(session.state().removed > expectedRemoved);
  playUntil(1e9);
  CHECK(session.state().removed == expectedRemoved);
  CHECK(session.state().moment.branch >= 1);

  session.play(1e9);
  session.tools().take(0);  // before the start is reached
  CHECK_FALSE(session.playing());
  session.operation().waitForAnswer();
  session.update();
  CHECK_FALSE(session.operation().playing());
  CHECK(session.state().removed == 0);
}

TEST_CASE("when a scenario has been played, a hook that holds tissue keeps it") {
  Scenario scenario = readScenario(findDataFile("lift", "scenarios", ".toml"));
  scenario.organs[0].source.spacing = 0.012;
  scenario.duration = 3.6;  // the hook is up and holds the margin
  const ModelReader reader = [](const std::filesystem::path& p, const std::string& parts) {
    return readModel(p, parts);
  };
  auto simulation = std::make_unique<Simulation>(makeSimulation(scenario, reader));
  const auto hook = std::size_t(1);
  OperatingSession session(scenario, std::move(simulation), 1.6);
  session.play(1e9);
  while (session.playing()) {
    session.operation().waitFor(session.state().frame + 1);
    session.update();
  }
  session.operation().waitFor(session.state().frame + 60);
  session.update();
  CHECK(session.tools().isLeft(int(hook)));
  CHECK_FALSE(session.tools().isLeft(0));
  CHECK((session.tools().pose(int(hook)).position - scenario.tools[hook].keys[4].pose.position)
            .norm() < 2e-3);
  CHECK(session.state().inHand[hook] == 1);
  CHECK(session.state().forces[hook] > 0.05);  // N: the margin hangs on it
}

TEST_CASE("a drag ends when its tool is put back by a key") {
  OperatingBench bench;
  const SbVec2s at = bench.pixelOf(0);
  bench.button(at, true, SoMouseButtonEvent::BUTTON1);
  bench.move(SbVec2s(short(at[0] + 20), at[1]));
  REQUIRE(bench.tools().held() == 0);
  bench.key(SoKeyboardEvent::ESCAPE);
  const Vec3 rest = bench.tools().pose(0).position;
  bench.move(SbVec2s(short(at[0] + 40), at[1]));
  CHECK(bench.tools().held() == -1);
  CHECK(bench.tools().pose(0).position == rest);
}
