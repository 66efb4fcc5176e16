#include "io/mesh_file.h"

#include <doctest/doctest.h>

#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "formats/meshes/obj_file.h"
#include "formats/meshes/ply_file.h"
#include "formats/meshes/stl_file.h"
#include "formats/meshes/vtk_file.h"
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

TEST_CASE("what is written is read as the same triangles, in .stl in single precision") {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = unevenBall();
  using Reader = Model (*)(const std::string&, std::string_view);
  const std::pair<const char*, Reader> formats[] = {
      {"a.obj", readObjFile}, {"a.stl", readStlFile}, {"a.ply", readPlyFile}};
  for (const auto& [name, readFile] : formats) {
    CAPTURE(std::string(name));
    writeMeshFile(folder / name, mesh);
    const Model model = readFile(name, test::bytesOf(folder / name));
    REQUIRE(model.parts.size() == 1);
    const TriangleMesh& read = model.parts[0].mesh;
    REQUIRE(read.triangles.size() == mesh.triangles.size());
    const bool single = name == std::string("a.stl");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Vec3 &p = read.points[read.triangles[i][k]], &q = mesh.points[mesh.triangles[i][k]];
        CHECK((single ? p.cast<float>() == q.cast<float>() : p == q));
      }
  }
}

TEST_CASE("an unknown name is refused before anything is written") {
  const test::TemporaryFolder folder;
  CHECK_THROWS_AS(writeMeshFile(folder / "a.doc", unevenBall()), Error);
  CHECK_THROWS_AS(checkWritableMeshFile("surface"), Error);
  CHECK(std::filesystem::is_empty(folder.path()));
}
