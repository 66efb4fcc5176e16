// An instrument's plain mesh equals the shape in its Inventor file.
#include <doctest/doctest.h>

#include "inventor/reading/model_file.h"
#include "io/data_folder.h"
#include "io/organ_mesh.h"
#include "io/plain_mesh.h"

using namespace resect;

TEST_CASE("an instrument that is read without Inventor touches what it touches with it") {
  const std::vector<std::string> tools = shippedNames("tools", ".toml");
  REQUIRE(tools.size() >= 4);
  for (const std::string& name : tools) {
    CAPTURE(name);
    const auto file = dataFolder() / "tools" / (name + ".iv");
    const TriangleMesh shown = prepareOrganMesh(readModel(file), {}).mesh;
    const TriangleMesh plain = prepareOrganMesh(readPlainMesh(file), {}).mesh;
    // After a change of the model: resect convert data/tools/NAME.iv data/tools/NAME.ply
    CHECK(plain.points == shown.points);
    CHECK(plain.triangles == shown.triangles);
  }
}
