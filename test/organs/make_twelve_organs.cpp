// make_twelve_organs FOLDER: writes the twelve organs as people bring them, in mm (.stl).
#include <cstdio>
#include <filesystem>

#include "io/mesh_file.h"
#include "support/organs/twelve_organs.h"

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_twelve_organs FOLDER\n");
    return 2;
  }
  for (const char* name : resect::test::kTwelveOrgans) {
    resect::TriangleMesh mesh = resect::test::broughtOrgan(name).mesh;
    for (resect::Vec3& p : mesh.points) p *= 1e3;
    resect::writeMeshFile(std::filesystem::path(arguments[1]) / (std::string(name) + ".stl"), mesh);
  }
} catch (const std::exception& e) {
  std::fprintf(stderr, "make_twelve_organs: %s\n", e.what());
  return 1;
}
