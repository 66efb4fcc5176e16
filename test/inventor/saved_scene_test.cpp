// Saved scenes: what is saved comes back through the reader's child process, and what is damaged is
// told.
#include "inventor/scene/scene_file.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>

#include "io/data_folder.h"
#include "support/operating_bench.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::OperatingBench;

TEST_CASE("a scene that is saved comes back with organ, tools and camera") {
  OperatingBench bench;
  const test::TemporaryFolder folder;
  const auto file = folder / "scene.iv";
  bench.tools().setPose(1, {Vec3(0.1, 0.2, 0.05), toolBoxPlace(1).rotation});
  bench.session->look(RoomView::Top, 1.6);
  const auto surface = bench.session->operation().surface();
  writeSceneFile(file, bench.session->room(), surface);

  const Model model = readModel(file);
  const TriangleMesh& organ = partNamed(model, kOrganNode).mesh;
  CHECK(organ.triangles.size() == surface.mesh.triangles.size());
  REQUIRE(model.places);
  const ScenePlaces& places = *model.places;
  REQUIRE(places.tools.size() == bench.scenario.tools.size());
  CHECK((places.tools[1].position - Vec3(0.1, 0.2, 0.05)).norm() < 1e-6);
  CHECK(places.tools[1].rotation.angularDistance(toolBoxPlace(1).rotation) < 1e-6);
  SoPerspectiveCamera& camera = *bench.session->room().camera();
  const SbVec3f eye = camera.position.getValue();
  CHECK((places.camera.position - Vec3(eye[0], eye[1], eye[2])).norm() < 1e-5);
  CHECK(places.heightAngle == doctest::Approx(camera.heightAngle.getValue()));

  const SbRotation looking = camera.orientation.getValue();
  bench.session->look(RoomView::Surgeon, 1.6);
  REQUIRE_FALSE(looking.equals(camera.orientation.getValue(), 1e-3f));
  setCamera(bench.session->room(), places);
  CHECK((camera.position.getValue() - eye).length() < 1e-5f);
  CHECK(looking.equals(camera.orientation.getValue(), 1e-5f));
}

TEST_CASE("what is no saved scene has no places") {
  CHECK_FALSE(readModel(dataFolder() / "tools" / "scissors.iv").places);
}

namespace {

const std::string kCamera =
    "DEF Camera PerspectiveCamera { position 0 1 2 orientation 1 0 0 -0.5 focalDistance 2 "
    "heightAngle 0.7 }\n";
const std::string kTool = "DEF Tool_1 Transform { translation 0 0.1 0 rotation 0 1 0 1 }\n";

std::string scene(const std::string& nodes) {
  return "#Inventor V2.1 ascii\nSeparator {\nInfo { string \"Resect operation\" }\n" + nodes +
         "DEF Organ Separator { Cube { } }\n}\n";
}

}  // namespace

TEST_CASE("a saved scene whose camera or tools are nowhere gives one sentence, whoever opens it") {
  const test::TemporaryFolder folder;
  const auto file = folder.write("scene.iv", scene(kCamera + kTool));
  REQUIRE(readModel(file).places);
  const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  };
  const std::string damaged[] = {
      replaced(kCamera, "position 0", "position 1e300"),
      replaced(kCamera, "position 0", "position nan"),
      replaced(kCamera, "0 1 2", "1e30 -1e30 1e30"),
      replaced(kCamera, "focalDistance 2", "focalDistance 1e300"),
      replaced(kCamera, "focalDistance 2", "focalDistance -1"),
      replaced(kCamera, "focalDistance 2", "focalDistance 0"),
      replaced(kCamera, "heightAngle 0.7", "heightAngle 1e300"),
      replaced(kCamera, "heightAngle 0.7", "heightAngle 0"),
      replaced(kCamera, "1 0 0 -0.5", "1 0 0 1e300"),
      replaced(kCamera, "1 0 0 -0.5", "1e300 0 0 1"),
      kCamera + replaced(kTool, "0 0.1 0", "0 1e300 0"),
      kCamera + replaced(kTool, "0 0.1 0", "0 -1e7 0"),
      kCamera + replaced(kTool, "0 1 0 1", "0 1e300 0 1"),
  };
  for (const std::string& nodes : damaged) {
    CAPTURE(nodes);
    folder.write("scene.iv", scene(nodes));
    CHECK(test::refuses([&] { readModel(file); }, file.string()));
  }
  std::string many = kCamera;
  for (int i = 1; i <= 1001; ++i) many += "DEF Tool_" + std::to_string(i) + " Transform { }\n";
  folder.write("scene.iv", scene(many));
  CHECK(test::refuses([&] { readModel(file); }, "more than 1000 tools"));
}

TEST_CASE("a saved scene that calls other nodes camera and tools has no places") {
  const test::TemporaryFolder folder;
  const std::string nodes = "DEF Camera Separator { }\nDEF Tool_1 Separator { }\n";
  CHECK_FALSE(readModel(folder.write("scene.iv", scene(nodes))).places);
  const auto places = readModel(folder.write("scene.iv", scene(nodes + kCamera))).places;
  CHECK((!places || places->tools.empty()));
}
