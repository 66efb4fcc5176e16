#include "io/mesh_file.h"

#include <doctest/doctest.h>

#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "formats/assimp_file.h"
#include "formats/vtk_file.h"
#include "geometry/primitives.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

// Points whose last bits matter.
TriangleMesh unevenBall() {
  TriangleMesh mesh = sphereMesh({0.1, 0.2, -0.3}, 0.1, 8);
  Random random(5);
  for (Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) p[k] += random.uniform(-1e-4, 1e-4);
  return mesh;
}

TriangleMesh rounded(TriangleMesh mesh) {
  for (Vec3& p : mesh.points) p = p.cast<float>().cast<double>();
  return mesh;
}

}  // namespace

TEST_CASE("a .vtk file gives back every bit") {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = unevenBall();
  writeMeshFile(folder / "a.VTK", mesh);
  const Model model = readVtkFile("a", test::bytesOf(folder / "a.VTK"));
  REQUIRE(model.parts.size() == 1);
  CHECK(model.parts[0].mesh.points == mesh.points);
  CHECK(model.parts[0].mesh.triangles == mesh.triangles);
}

TEST_CASE("a .obj file has the digits of every double, and its triangles") {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = unevenBall();
  writeMeshFile(folder / "a.obj", mesh);
  std::istringstream in(test::bytesOf(folder / "a.obj"));
  TriangleMesh read;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string kind, a, b, c;
    words >> kind >> a >> b >> c;
    if (kind == "v") read.points.emplace_back(std::stod(a), std::stod(b), std::stod(c));
    if (kind == "f")
      read.triangles.push_back({std::stoi(a) - 1, std::stoi(b) - 1, std::stoi(c) - 1});
  }
  CHECK(read.points == mesh.points);
  CHECK(read.triangles == mesh.triangles);
}

TEST_CASE("what is written as .obj, .stl and .ply is read as the same triangles") {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = unevenBall();
  for (const char* name : {"a.obj", "a.stl", "a.ply"}) {
    CAPTURE(name);
    writeMeshFile(folder / name, mesh);
    const Model model = readAssimpFile(folder / name, folder / name, test::bytesOf(folder / name));
    REQUIRE(model.parts.size() == 1);
    const TriangleMesh& read = model.parts[0].mesh;
    REQUIRE(read.triangles.size() == mesh.triangles.size());
    // The library keeps single precision; its text parser may miss the last bit of it.
    const TriangleMesh expected = rounded(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k)
        CHECK((read.points[read.triangles[i][k]] - expected.points[mesh.triangles[i][k]]).norm() <
              1e-7);
  }
}

TEST_CASE("an unknown name is refused before anything is written") {
  const test::TemporaryFolder folder;
  CHECK_THROWS_AS(writeMeshFile(folder / "a.doc", unevenBall()), Error);
  CHECK_THROWS_AS(checkWritableMeshFile("surface"), Error);
  CHECK(std::filesystem::is_empty(folder.path()));
}
