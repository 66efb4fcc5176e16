// Files as people bring them, read as the program reads them, up to the organ.
#include <doctest/doctest.h>

#include "base/error.h"
#include "geometry/measures.h"
#include "inventor/reading/model_file.h"
#include "io/organ_mesh.h"
#include "support/sentence.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

struct Case {
  const char* file;
  double ml;  // of the organ
};

}  // namespace

TEST_CASE("Inventor and VRML text is read with what some programs put round it") {
  const std::string box = "Separator { Cube { width 1 height 1 depth 1 } }\n";
  const std::string vrml = "#VRML V2.0 utf8\nShape { geometry Box { size 1 1 1 } }\n";
  const test::TemporaryFolder folder;
  for (const std::string& text : {"#Inventor V2.1 ascii\n" + box, vrml})
    for (const std::string& file : {text, "\xef\xbb\xbf" + text, "\r\n" + text, text + '\0',
                                    text + "\x1a", text.substr(0, text.size() - 1)})
      CHECK(volume(merged(readModel(folder.write("box.wrl", file)))) == doctest::Approx(1));
}

TEST_CASE("a byte order mark before a text of any kind is passed over") {
  const std::string mark = "\xef\xbb\xbf";
  const std::string three = "0 0 0\n2 0 0\n0 1 0\n";
  const std::pair<const char*, std::string> files[] = {
      {"a.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"a.off", "OFF\n3 1 0\n" + three + "3 0 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
       "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
       "end_header\n" +
           three + "3 0 1 2\n"},
      {"a.stl",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid\n"},
      {"a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n" + three +
                    "POLYGONS 1 4\n3 0 1 2\n"}};
  const test::TemporaryFolder folder;
  for (const auto& [name, text] : files) {
    CAPTURE(std::string(name));
    CHECK(area(merged(readModel(folder.write(name, text)))) == doctest::Approx(1));
    CHECK(area(merged(readModel(folder.write(name, mark + text)))) == doctest::Approx(1));
  }
}

TEST_CASE("small files that other programs wrote have their volume") {
  const auto folder = test::sharedData("cases");
  if (!folder) return;
  for (const Case& one :
       {Case{"01_dot_number_silent.obj", 1000}, Case{"02_dot_number_refused.obj", 1000},
        Case{"03_quantized_silent.glb", 180.34}, Case{"04_quantized_refused.glb", 180.34},
        Case{"05_first_byte_0A.ply", 1000}, Case{"06_string_field.vtk", 1000},
        Case{"12_binary_trailing_bytes.stl", 1000}, Case{"13_ascii_upper.stl", 1000},
        Case{"21_faces_first.ply", 1000}, Case{"23_names_with_spaces.obj", 2000},
        Case{"07_cavity_inner_outward.stl", 1000}, Case{"15_face_and_its_back.stl", 1000}}) {
    CAPTURE(one.file);
    const OrganMesh organ = prepareOrganMesh(readModel(*folder / one.file));
    CHECK(organ.volume * 1e6 == doctest::Approx(one.ml).epsilon(1e-4));
  }
  CHECK(test::refuses([&] { readModel(*folder / "18_torn_text.ply"); }, "the file ends early"));
  const Model kidney = readModel(*folder / "23_names_with_spaces.obj");
  REQUIRE(kidney.parts.size() == 2);
  CHECK(kidney.parts[0].name == "left kidney");
  const Model patches = readModel(*folder / "25_two_patches.obj");
  CHECK(prepareOrganMesh(patches, {partLines({"capsule", "bare_area"})}).volume ==
        doctest::Approx(1e-3));
}
