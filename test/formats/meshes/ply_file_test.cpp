#include "formats/meshes/ply_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "formats/meshes/cube_text.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "support/sentence.h"

using namespace resect;

namespace {

const std::string kVertices =
    "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 12\nproperty list uchar int vertex_indices\n";
const std::string kText = "ply\nformat ascii 1.0\ncomment a cube\n";
const std::string kEnd = "end_header\n";

std::string textPly() {
  return kText + kVertices + kFaces + kEnd + test::cubePoints() + test::cubeFaces("3 ", 0);
}

// `scale` of the points decides the first byte of data: that of x of point 0 is `first`.
template <typename Index>
std::string binaryPly(std::string header, bool bigEndian, float first = 0) {
  const auto put = [&](auto value) {
    char data[sizeof(value)];
    std::memcpy(data, &value, sizeof(value));
    if (bigEndian) std::reverse(std::begin(data), std::end(data));
    header.append(data, sizeof(value));
  };
  const TriangleMesh cube = test::cube();
  for (const Vec3& p : cube.points)
    for (int k = 0; k < 3; ++k) put(k == 0 && p.x() == 0 ? first : float(p[k]));
  for (const Triangle& t : cube.triangles) {
    put(std::uint8_t(3));
    for (const std::int32_t i : t) put(Index(i));
  }
  return header;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

void checkPlyCube(const std::string& bytes, double volumeOfIt = 1) {
  const Model model = readPlyFile("a.ply", bytes);
  REQUIRE(model.parts.size() == 1);
  CHECK(topology(model.parts[0].mesh).closed());
  CHECK(volume(model.parts[0].mesh) == doctest::Approx(volumeOfIt));
}

std::string sentenceOfPly(const std::string& bytes) {
  return test::sentenceOf([&] { readPlyFile("a.ply", bytes); });
}

}  // namespace

TEST_CASE("a .ply is read as text and binary of both byte orders, whatever ends its lines") {
  checkPlyCube(textPly());
  checkPlyCube(replaced(textPly(), "\n", "\r\n"));
  checkPlyCube(replaced(textPly(), "\n", "\r"));
  for (const bool big : {false, true})
    for (const char* end : {"\n", "\r\n", "\r"}) {
      CAPTURE(big);
      const std::string form = big ? "binary_big_endian" : "binary_little_endian";
      const std::string header =
          replaced(replaced(kText, "ascii", form) + kVertices + kFaces + kEnd, "\n", end);
      checkPlyCube(binaryPly<std::int32_t>(header, big));
      checkPlyCube(binaryPly<std::uint16_t>(replaced(header, "int vertex", "ushort vertex"), big));
      checkPlyCube(binaryPly<std::int8_t>(replaced(header, "int vertex", "int8 vertex"), big));
    }
}

TEST_CASE("every first byte of binary data belongs to the data") {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string header = replaced(
        replaced(kText, "ascii", "binary_little_endian") + kVertices + kFaces + kEnd, "\n", end);
    for (int byte = 0; byte < 256; ++byte) {
      CAPTURE(byte);
      const std::uint32_t bits = 0xbe000000u | std::uint32_t(byte);  // -0.125 and a little less
      float first = 0;
      std::memcpy(&first, &bits, sizeof(first));
      checkPlyCube(binaryPly<std::int32_t>(header, false, first), 1.125);
    }
  }
}

TEST_CASE("elements of a .ply come in any order, with others between them and bytes after them") {
  checkPlyCube(kText + kFaces + kVertices + kEnd + test::cubeFaces("3 ", 0) + test::cubePoints());
  const std::string others =
      "element camera 2\nproperty float view\nproperty list uchar float lens\n";
  checkPlyCube(kText + others + kVertices + others + kFaces + kEnd + "7 2 0.5 nan\n8 0\n" +
               test::cubePoints() + "7 0\n8 1 1\n" + test::cubeFaces("3 ", 0) + "edge 1 2");
  const std::string coloured =
      kText + "element vertex 8\nproperty uchar red\nproperty double z\nproperty double y\n" +
      "property double x\nproperty list uchar int more\n";
  std::string points;
  for (const Vec3& p : test::cube().points)
    points += fmt::format("255 {} {} {} 2 9 9\n", p.z(), p.y(), p.x());
  checkPlyCube(coloured + replaced(kFaces, "vertex_indices", "vertex_index") + kEnd + points +
               test::cubeFaces("3 ", 0));
}

TEST_CASE("a .ply is read with its words in capitals") {
  std::string capitals = kText + kVertices + kFaces + kEnd;
  for (char& c : capitals) c = char(std::toupper(static_cast<unsigned char>(c)));
  checkPlyCube(capitals + test::cubePoints() + test::cubeFaces("3 ", 0));
  CHECK(startsAsPly(capitals));
}

TEST_CASE("strips of a .ply turn every second triangle and end at -1") {
  const std::string text =
      kText + "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
      "element tristrips 1\nproperty list int int vertex_indices\n" + kEnd +
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n14 0 2 1 3 -1 0 3 2 -1 0 1 3 -1 -1\n";
  const TriangleMesh mesh = readPlyFile("a.ply", text).parts.at(0).mesh;
  REQUIRE(mesh.triangles.size() == 4);
  CHECK(mesh.triangles[1] == Triangle{1, 2, 3});
  CHECK(mesh.triangles[3] == Triangle{0, 1, 3});
}

TEST_CASE("a torn .ply is refused wherever it is torn, with what it holds") {
  const std::string text = textPly();
  for (std::size_t length = 5; length + 7 < text.size(); length += 7) {
    CAPTURE(length);
    CHECK(test::isOneSentence(sentenceOfPly(text.substr(0, length))));
  }
  const std::string binary = binaryPly<std::int32_t>(
      replaced(kText, "ascii", "binary_little_endian") + kVertices + kFaces + kEnd, false);
  for (std::size_t length = 5; length < binary.size(); length += 7) {
    CAPTURE(length);
    CHECK(test::isOneSentence(sentenceOfPly(binary.substr(0, length))));
  }
  const std::size_t last = text.rfind("\n3 1 3 7");
  CHECK(test::isRefusalOf("a.ply: ", "it promises 12 elements 'face' and holds 10",
                          sentenceOfPly(text.substr(0, last))));
  CHECK(test::isRefusalOf("a.ply: ", "it promises 12 elements 'face' and holds 11",
                          sentenceOfPly(binary.substr(0, binary.size() - 1))));
}

TEST_CASE("a damaged .ply is refused with the place of the damage") {
  const auto refuses = [&](const std::string& from, const std::string& to,
                           const std::string& what) {
    const std::string said = sentenceOfPly(replaced(textPly(), from, to));
    CHECK_MESSAGE(test::isRefusalOf("a.ply:", what, said), said);
  };
  refuses("ascii", "morse", "a.ply:2: has the unknown format 'morse'");
  refuses("format ascii 1.0\n", "", "names no format");
  refuses("float x", "quaternion x", "a.ply:5: has numbers of the unknown type 'quaternion'");
  refuses("vertex 8", "vertex eight", "a.ply:4: has 'eight'");
  refuses("vertex 8", "vertex -8", "'-8'");
  refuses("face 12", "face 2000000", "a.ply:8: the file ends early");
  refuses("comment", "remark", "a.ply:3: has 'remark'");
  refuses("property float z\n", "", "no x, y and z");
  refuses("vertex_indices", "corners", "no list vertex_indices");
  refuses("3 0 2 3", "3 0 2 8", "face 0 uses point 8 of only 8");
  refuses("3 0 2 3", "3 0 2 -1", "face 0 uses point -1 of only 8");
  refuses("3 0 2 3", "3 0 2 2.5", "face 0 uses point 2.5");
  refuses("3 0 2 3", "-3 0 2 3", "face 0 has -3 numbers");
  refuses("3 0 2 3", "99999 0 2 3", "the file ends early");
  refuses("1 1 1\n", "1 1 x\n", "has 'x' where a number should be");
  const std::string cloud = kText + kVertices + kEnd + test::cubePoints();
  CHECK(test::refuses([&] { readPlyFile("a.ply", cloud); }, "points and no faces"));
  CHECK(test::refuses([&] { readPlyFile("a.ply", kText + "property float x\n" + kEnd); },
                      "before any element"));
}
