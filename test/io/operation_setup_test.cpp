#include "io/operation_setup.h"

#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "io/scenario/scenario_file.h"
#include "organ/builtin/builtin_gallbladder.h"

using namespace resect;

TEST_CASE("the source \"gallbladder\" is the built-in gallbladder, no file") {
  const Scenario scenario = parseScenario(
      "title = \"Gallbladder\"\nduration = 1\n[organ]\nsource = \"gallbladder\"\non_table = "
      "false\n",
      "test.toml");
  const auto noFile = [](const std::filesystem::path&) -> Model {
    FAIL("no file is read");
    return {};
  };
  const TriangleMesh mesh = loadOrganMesh(scenario.organs[0].source, noFile, nullptr);
  CHECK(mesh.points == builtinGallbladder().points);
  CHECK(mesh.triangles == builtinGallbladder().triangles);
}
