// make_organs FOLDER: writes the organs that come along (data/organs/*.ply) as their formulas give
// them, and the liver's vessels. Reading such a file takes 2 ms, the formula 700.
#include <cstdio>
#include <filesystem>

#include "anatomy/growth/vessel_growth.h"
#include "io/mesh_file.h"
#include "io/vessels_file.h"
#include "organ/builtin/builtin_gallbladder.h"
#include "organ/builtin/builtin_liver.h"

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_organs FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  const resect::TriangleMesh liver = resect::builtinLiver();
  resect::writeMeshFile(folder / "liver.ply", liver);
  resect::writeVessels(folder / "liver.vessels",
                       resect::growVessels(liver, resect::builtinLiverVessels()));
  resect::writeMeshFile(folder / "gallbladder.ply", resect::builtinGallbladder());
} catch (const std::exception& e) {
  std::fprintf(stderr, "make_organs: %s\n", e.what());
  return 1;
}
