#include "formats/meshes/obj_file.h"

#include <doctest/doctest.h>

#include "formats/meshes/cube_text.h"
#include "geometry/measures.h"
#include "geometry/repair/weld.h"
#include "geometry/topology.h"
#include "support/sentence.h"

using namespace resect;

namespace {

Model readObj(const std::string& text) { return readObjFile("a.obj", text); }

void checkObjCube(const std::string& text, double volumeOfIt = 1) {
  CAPTURE(text);
  const Model model = readObj(text);
  REQUIRE(model.parts.size() == 1);
  CHECK(topology(weld(model.parts[0].mesh)).closed());
  CHECK(volume(model.parts[0].mesh) == doctest::Approx(volumeOfIt));
}

std::string cubeAt(const std::string& header, int first) {
  return header + test::cubePoints("v ") + test::cubeFaces("f ", first);
}

std::string sentenceOfObj(const std::string& text) {
  return test::sentenceOf([&] { readObj(text); });
}

}  // namespace

TEST_CASE("an .obj's coordinates are read in every way of printing them") {
  for (const char* one : {"1", "1.", "+1", "1.0", "10e-1", "10E-01", "10d-1", "01"})
    checkObjCube(test::cubePoints("v ", one) + test::cubeFaces("f ", 1));
  checkObjCube(test::cubePoints("v ", ".5") + test::cubeFaces("f ", 1), 0.125);
  // A point that nobody uses would hide that another one was dropped.
  checkObjCube(test::cubePoints("v ", ".5") + "v 9 9 9\n" + test::cubeFaces("f ", 1), 0.125);
}

TEST_CASE("an .obj is read whatever ends its lines, with comments, capitals and a padded end") {
  const std::string plain = cubeAt("# a cube \\\nmtllib c:\\a.mtl\n", 1);
  checkObjCube(plain);
  checkObjCube("\xef\xbb\xbf" + plain);
  checkObjCube(plain + std::string(3, '\0'));
  checkObjCube(plain + "\x1a");
  std::string windows, mac;
  for (const char c : plain) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  checkObjCube(windows);
  checkObjCube(mac);
  checkObjCube(test::cubePoints("V\t") + test::cubeFaces("  F ", 1));
  checkObjCube(test::cubePoints("v \\\n") + "f 1 3 4 \\\n2 # one side, on two lines\n" +
               test::cubeFaces("f ", 1).substr(16));
}

TEST_CASE(
    "an .obj's faces may count back, come first, have many corners, and name more than points") {
  checkObjCube(test::cubePoints("v ") + test::cubeFaces("f ", -8));
  checkObjCube(test::cubeFaces("f ", 1) + test::cubePoints("v "));
  checkObjCube(test::cubePoints("v ") +
               "f 1/1 3/2 4/3 2/4\nf 5//1 6//1 8//1 7//1\nf 1/1/1 2/1/1 6/1/1 5/1/1\nf 3 7 8 4\n"
               "f 1 5 7 3\nf 2 4 8 6\n");
  const std::string real = "f 1.000000e+00 3.000000e+00 4.000000e+00\n";
  checkObjCube(test::cubePoints("v ") + real + test::cubeFaces("f ", 1).substr(8));
}

TEST_CASE("a weight divides a vertex, a colour does not") {
  std::string weighted, coloured;
  for (const Vec3& p : test::cube().points) {
    weighted += fmt::format("v {} {} {} 2\n", p.x(), p.y(), p.z());
    coloured += fmt::format("v {} {} {} 0.2 0.3 0.4\n", p.x(), p.y(), p.z());
  }
  checkObjCube(weighted + test::cubeFaces("f ", 1), 0.125);
  checkObjCube(coloured + test::cubeFaces("f ", 1));
}

TEST_CASE("parts of an .obj have their whole names") {
  const Model model =
      readObj(cubeAt("o left kidney\n", 1) + cubeAt("g  left lung  \n", 9) +
              cubeAt("o tumour #2\n", 17) + "g\nf 17 18 19\ng left lung\nf 9 10 11\n");
  REQUIRE(model.parts.size() == 3);
  CHECK(model.parts[0].name == "left kidney");
  CHECK(model.parts[1].name == "left lung");
  CHECK(model.parts[2].name == "tumour #2");
  CHECK(model.parts[0].mesh.points.size() == 8);
  CHECK(model.parts[1].mesh.triangles.size() == 13);
  CHECK(model.parts[2].mesh.triangles.size() == 13);
}

TEST_CASE("parts of an .obj may share points") {
  const Model model = readObj(test::cubePoints("v ") + "o top\nf 5 6 8 7\no bottom\nf 1 3 4 2\n");
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].mesh.points.size() == 4);
  CHECK(model.parts[1].mesh.points.size() == 4);
}

TEST_CASE("a damaged .obj is refused with its line") {
  const auto refuses = [](const std::string& text, const std::string& line,
                          const std::string& what) {
    CHECK_MESSAGE(test::isRefusalOf("a.obj:" + line + ": ", what, sentenceOfObj(text)),
                  sentenceOfObj(text));
  };
  refuses("v 0 0 0\nv 1 0\n", "2", "vertex of 2 numbers");
  refuses("v 0 0 0\nv 1 0 x\n", "2", "has 'x' where a coordinate");
  refuses("v 0 0 0\nv 1,0 0 0\n", "2", "not with commas");
  refuses("v 0 0 0 0\n", "1", "weight 0");
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  refuses(three + "f 1 2\n", "4", "face of 2 corners");
  refuses(three + "f 1 2 4\n", "4", "point 4 of only 3");
  refuses(three + "f 1 2 -4\n", "4", "point -4 of only 3");
  refuses(three + "f 0 1 2\n", "4", "counted from 1");
  refuses(three + "f 1 2 3/1/1 x\n", "4", "has 'x' where the number of a point");
  refuses(three + "\n\nf 1 2 99999999999999999999\n", "6", "99999999999999999999");
}
