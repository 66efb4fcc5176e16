// Meshes written by Resect are read back, damaged ones rejected.
#include "io/plain_mesh.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "base/random.h"
#include "geometry/primitives.h"
#include "io/mesh_file.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::bytesOf;

TEST_CASE("a mesh comes back bit for bit, also where another ending is asked for") {
  const test::TemporaryFolder folder;
  Random random(7);
  TriangleMesh mesh = sphereMesh({0.1, -0.2, 0.3}, 0.05, 9);
  for (Vec3& p : mesh.points) p *= 1 + 1e-9 * random.uniform();
  writeMeshFile(folder / "ball.ply", mesh);
  for (const char* name : {"ball.ply", "ball.iv"}) {
    const Model model = readPlainMesh(folder / name);
    REQUIRE(model.parts.size() == 1);
    CHECK(model.parts[0].mesh.points == mesh.points);
    CHECK(model.parts[0].mesh.triangles == mesh.triangles);
  }
}

TEST_CASE("what is missing, cut off, longer, or of another form is refused in a sentence") {
  const test::TemporaryFolder folder;
  const auto file = folder / "box.ply";
  CHECK_THROWS_WITH_AS(readPlainMesh(file), doctest::Contains("there is no plain mesh"), Error);
  writeMeshFile(file, boxMesh({{0, 0, 0}, {1, 1, 1}}));
  const std::string whole = bytesOf(file);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder.write("box.ply", whole.substr(0, size));
    CHECK_THROWS_AS(readPlainMesh(file), Error);
  }
  folder.write("box.ply", whole + "x");
  CHECK_THROWS_WITH_AS(readPlainMesh(file), doctest::Contains("cut off or damaged"), Error);
  std::string other = whole;
  other.replace(other.find("double x"), 8, "float  x");
  folder.write("box.ply", other);
  CHECK_THROWS_AS(readPlainMesh(file), Error);
  std::filesystem::create_directory(folder / "folder.ply");
  CHECK_THROWS_WITH_AS(readPlainMesh(folder / "folder.ply"), doctest::Contains("is not a file"),
                       Error);
  // An index without its point, in the last triangle.
  other = whole;
  other[other.size() - 2] = 1;
  folder.write("box.ply", other);
  CHECK_THROWS_AS(readPlainMesh(file), Error);
}
