#include "formats/meshes/vtk_file.h"

#include <doctest/doctest.h>

#include <bit>
#include <cstring>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "support/sentence.h"

using namespace resect;

namespace {

const std::string kHead =
    "# vtk DataFile Version 3.0\ntitle of any kind\nASCII\nDATASET POLYDATA\n";
const std::string kTetrahedron = kHead +
                                 "POINTS 4 float\n0 0 0 1 0 0\n0 1 0 0 0 1\n"
                                 "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

template <typename T>
std::string bigEndian(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) {
    char data[sizeof(T)];
    std::memcpy(data, &value, sizeof(T));
    std::reverse(std::begin(data), std::end(data));
    bytes.append(data, sizeof(T));
  }
  return bytes;
}

TriangleMesh readVtk(const std::string& bytes) {
  Model model = readVtkFile("a.vtk", bytes);
  return model.parts.empty() ? TriangleMesh() : model.parts[0].mesh;
}

void checkTetrahedron(const TriangleMesh& mesh) {
  REQUIRE(mesh.points.size() == 4);
  REQUIRE(mesh.triangles.size() == 4);
  CHECK(topology(mesh).closed());
  CHECK(volume(mesh) == doctest::Approx(1.0 / 6));
}

std::string sentenceOfVtk(const std::string& bytes) {
  return test::sentenceOf([&] { readVtkFile("a.vtk", bytes); });
}

}  // namespace

TEST_CASE("text, binary and 5.1 forms of a tetrahedron are the same") {
  checkTetrahedron(readVtk(kTetrahedron));
  std::string binaryHead = kHead;
  binaryHead.replace(binaryHead.find("ASCII"), 5, "BINARY");
  const std::string points =
      "POINTS 4 double\n" + bigEndian<double>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) + "\n";
  checkTetrahedron(
      readVtk(binaryHead + points + "POLYGONS 4 16\n" +
              bigEndian<std::int32_t>({3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3}) + "\n"));
  checkTetrahedron(readVtk(
      binaryHead + points + "METADATA\nINFORMATION 0\n\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n" +
      bigEndian<std::int64_t>({0, 3, 6, 9, 12}) + "\nCONNECTIVITY vtktypeint64\n" +
      bigEndian<std::int64_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}) + "\n"));
  checkTetrahedron(readVtk(kHead + "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"
                                   "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\n"
                                   "CONNECTIVITY vtktypeint64\n0 2 1 0 1 3 0 3 2 1 2 3\n"));
}

TEST_CASE("strips turn every second triangle; attributes, lines and fields are passed over") {
  const TriangleMesh mesh =
      readVtk(kHead +
              "FIELD FieldData 1\nTimeValue 1 1 double\n0.5\n"
              "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nLINES 1 3\n2 0 3\nVERTICES 1 2\n1 0\n"
              "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n"
              "POINT_DATA 4\nSCALARS nonsense float\nLOOKUP_TABLE default\nx y z w\n");
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(area(mesh) == doctest::Approx(1));
  CHECK(topology(mesh).oriented());
  CHECK(topology(mesh).boundaryEdges == 4);
  CHECK(mesh.triangles[1] == Triangle{2, 1, 3});
}

TEST_CASE("polygons of many corners become triangles") {
  const TriangleMesh mesh = readVtk(kHead +
                                    "POINTS 5 double\n0 0 0 4 0 0 4 4 0 2 1 0 0 4 0\n"
                                    "POLYGONS 1 6\n5 0 1 2 3 4\n");
  CHECK(mesh.triangles.size() == 3);
  CHECK(area(mesh) == doctest::Approx(10));
}

TEST_CASE("a damaged text is refused with its line, whatever ends the lines") {
  const std::string text =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0\n1 0 x\n0 1 "
      "0\n";
  CHECK(sentenceOfVtk(text).starts_with("a.vtk:7: section POINTS has 'x'"));
  std::string windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(sentenceOfVtk(windows).starts_with("a.vtk:7: section POINTS has 'x'"));
}

TEST_CASE("a damaged file is refused with the section it is in") {
  const auto refuses = [](const std::string& bytes, const std::string& what) {
    const std::string text = sentenceOfVtk(bytes);
    CHECK_MESSAGE(test::isRefusalOf("a.vtk:", what, text), text);
  };
  refuses("", "header");
  refuses("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n", "UNSTRUCTURED_GRID");
  refuses("# vtk DataFile Version 3.0\nt\nMORSE\nDATASET POLYDATA\n", "MORSE");
  refuses(kHead, "POINTS is missing");
  refuses(kHead + "POINTS -4 float\n", "has -4 points");
  refuses(kHead + "POINTS four float\n", "'four'");
  refuses(kHead + "POINTS 4000000000 float\n0 0 0\n", "4000000000 points");
  refuses(kHead + "POINTS 400000000 float\n0 0 0\n", "the file ends before");
  refuses(kHead + "POINTS 1 quaternion\n0 0 0\n", "quaternion");
  refuses(kHead + "POINTS 1 float\n0 0 x\n", "'x'");
  refuses(kHead + "POLYGONS 1 4\n3 0 1 2\n", "POINTS must come before");
  const std::string three = kHead + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  refuses(three + "POLYGONS 1 4\n3 0 1 3\n", "point 3 of only 3");
  refuses(three + "POLYGONS 1 4\n3 0 1 -1\n", "point -1 of only 3");
  refuses(three + "POLYGONS 1 4\n9 0 1 2\n", "cell of 9 corners");
  refuses(three + "POLYGONS 1 4\n-3 0 1 2\n", "cell of -3 corners");
  refuses(three + "POLYGONS 2 4\n3 0 1 2\n", "2 cells but numbers for only 1");
  refuses(three + "POLYGONS 1 8\n3 0 1 2 3 0 1 2\n", "4 numbers too many");
  refuses(three + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 7\nCONNECTIVITY vtktypeint64\n0 1 2\n",
          "offset 7");
  refuses(three + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\n", "CONNECTIVITY");
  refuses(three + "GARBAGE 1 2\n", "GARBAGE");
  std::string binary = three;
  binary.replace(binary.find("ASCII"), 5, "BINARY");
  refuses(binary, "the file ends before");
}

TEST_CASE("arrays of texts, bits and odd numbers in a field are passed over, as text and binary") {
  const std::string body = kTetrahedron.substr(kHead.size());
  const std::string field =
      "FIELD FieldData 4\nSPACE 1 1 string\nRAS\nnotes 1 3 utf8_string\na%20b\n\nPOINTS 8 float\n"
      "flags 1 9 bit\n1 0 1 0 1 0 1 0 1\nvalues 2 1 double\nnan -1.#IND\n";
  checkTetrahedron(readVtk(kHead + field + body));
  std::string binaryHead = kHead;
  binaryHead.replace(binaryHead.find("ASCII"), 5, "BINARY");
  const std::string longText(100, 'x');  // its length takes two bytes
  std::string texts("\xc3RAS", 4);
  texts += std::string("\xc0", 1) + std::string("\x80\x64", 2) + longText;
  checkTetrahedron(
      readVtk(binaryHead + "FIELD FieldData 3\nspace 1 3 string\n" + texts + "\nflags 1 9 bit\n" +
              std::string("\n\n", 2) + "\nvalues 1 2 vtktypeint64\n" +
              bigEndian<std::int64_t>({10, 20}) + "\nPOINTS 4 float\n" +
              bigEndian<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) + "\nPOLYGONS 4 16\n" +
              bigEndian<std::int32_t>({3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3}) + "\n"));
  CHECK(test::tells(sentenceOfVtk(kHead + "FIELD f 1\na 1 9 string\nx\n"), "fewer texts"));
  CHECK(test::tells(sentenceOfVtk(kHead + "FIELD f 1\na 1 9 bit\n1 0\n"), "fewer numbers"));
  CHECK(test::tells(sentenceOfVtk(binaryHead + "FIELD f 1\na 1 1 string\n\xc9xx"),
                    "longer than the file"));
  CHECK(test::tells(sentenceOfVtk(kHead + "FIELD f 1\na 1 1 rune\nx\n"), "unknown type 'rune'"));
}

TEST_CASE("words of a .vtk may be in small letters or capitals, and bytes may follow") {
  std::string small = kTetrahedron;
  for (std::size_t i = kHead.find("ASCII"); i < small.size(); ++i)
    small[i] = char(std::tolower(static_cast<unsigned char>(small[i])));
  checkTetrahedron(readVtk(small));
  checkTetrahedron(readVtk(kTetrahedron + std::string(4, '\0') + "\x1a"));
  std::string numbers = kTetrahedron;
  numbers.replace(numbers.find("0 0 0 1 0 0"), 11, ".0 0. +0 1.E0 0d0 -0");
  checkTetrahedron(readVtk(numbers));
}
