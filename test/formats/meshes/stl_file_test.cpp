#include "formats/meshes/stl_file.h"

#include <doctest/doctest.h>

#include <cstring>

#include "formats/meshes/cube_text.h"
#include "geometry/measures.h"
#include "geometry/repair/weld.h"
#include "geometry/topology.h"
#include "support/sentence.h"

using namespace resect;

namespace {

std::string binaryStl(std::string header, std::uint32_t count = 12) {
  header.resize(80, ' ');
  const auto put = [&](auto value) {
    char data[sizeof(value)];
    std::memcpy(data, &value, sizeof(value));
    header.append(data, sizeof(value));
  };
  put(count);
  const TriangleMesh cube = test::cube();
  for (const Triangle& t : cube.triangles) {
    for (int k = 0; k < 3; ++k) put(std::numeric_limits<float>::quiet_NaN());  // normal
    for (const std::int32_t i : t)
      for (int k = 0; k < 3; ++k) put(float(cube.points[std::size_t(i)][k]));
    put(std::uint16_t(0x8001));
  }
  return header;
}

std::string textStl(const std::string& name, const std::string& normal = "0 0 1") {
  std::string text = "solid " + name + "\n";
  const TriangleMesh cube = test::cube();
  for (const Triangle& t : cube.triangles) {
    text += "  facet normal " + normal + "\n    outer loop\n";
    for (const std::int32_t i : t) {
      const Vec3& p = cube.points[std::size_t(i)];
      text += fmt::format("      vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

void checkStlCube(const std::string& bytes) {
  const Model model = readStlFile("a.stl", bytes);
  REQUIRE(model.parts.size() == 1);
  const TriangleMesh mesh = weld(model.parts[0].mesh);
  CHECK(mesh.points.size() == 8);
  CHECK(topology(mesh).closed());
  CHECK(volume(mesh) == doctest::Approx(1));
}

std::string sentenceOfStl(const std::string& bytes) {
  return test::sentenceOf([&] { readStlFile("a.stl", bytes); });
}

}  // namespace

TEST_CASE("a binary .stl is read whatever its header and what follows its triangles") {
  for (const char* header :
       {"", "solid cube", "solid facet endsolid", "ply\n", "OFF", "glTF", "# vtk"})
    checkStlCube(binaryStl(header));
  for (const std::size_t more : {1, 2, 49, 50, 1000}) {
    checkStlCube(binaryStl("exported") + std::string(more, '\0'));
    checkStlCube(binaryStl("solid facet endsolid") + std::string(more, 'x'));
  }
}

TEST_CASE("a text .stl is read in capitals, with any normals, line ends and names") {
  checkStlCube(textStl("cube"));
  checkStlCube(upper(textStl("cube")));
  checkStlCube(textStl("", "nan nan nan"));
  checkStlCube(textStl("", "-1.#IND 1.#QNAN 0"));
  checkStlCube("\xef\xbb\xbf" + textStl("cube") + std::string(5, '\0') + "\x1a");
  checkStlCube("\r\n " + textStl("cube"));
  std::string windows, twoWords = textStl("cube");
  for (const char c : textStl("cube")) windows += c == '\n' ? "\r\n" : std::string(1, c);
  checkStlCube(windows);
  for (std::size_t at = twoWords.find("end"); at != twoWords.npos;
       at = twoWords.find("end", at + 1))
    twoWords.replace(at, 3, "end ");
  checkStlCube(twoWords);
}

TEST_CASE("solids of a text .stl are parts by their whole names") {
  const Model model =
      readStlFile("a.stl", textStl("left kidney") + textStl("left lung") + textStl("left lung"));
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].name == "left kidney");
  CHECK(model.parts[1].name == "left lung");
  CHECK(model.parts[1].mesh.triangles.size() == 24);
}

TEST_CASE("a torn .stl is refused wherever it is torn") {
  const std::string binary = binaryStl("exported"), text = textStl("cube");
  for (std::size_t length = 0; length < binary.size(); length += 37) {
    CAPTURE(length);
    CHECK(test::isOneSentence(sentenceOfStl(binary.substr(0, length))));
  }
  CHECK(test::tells(sentenceOfStl(binary.substr(0, 400)),
                    "the file ends early: it promises 12 triangles and holds 6"));
  CHECK(
      test::tells(sentenceOfStl(binaryStl("exported", 13)), "promises 13 triangles and holds 12"));
  CHECK(test::tells(sentenceOfStl(binaryStl("exported", 0)), "no triangles, but 600 bytes follow"));
  // The last line may be torn without loss.
  for (std::size_t length = 30; length < text.size() - sizeof("endsolid cube"); length += 11) {
    CAPTURE(length);
    CHECK(test::isOneSentence(sentenceOfStl(text.substr(0, length))));
  }
  CHECK(test::tells(sentenceOfStl(text.substr(0, text.size() - 15)), "the file ends early"));
}

TEST_CASE("a damaged text .stl is refused with its line") {
  const std::string text = textStl("cube");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return sentenceOfStl(other);
  };
  CHECK(test::isRefusalOf("a.stl:4: ", "has 'x' where a coordinate",
                          changed("vertex 0", "vertex x")));
  CHECK(test::isRefusalOf("a.stl:4: ", "with commas", changed("vertex 0", "vertex 0,0")));
  CHECK(test::isRefusalOf("a.stl:3: ", "'outer'", changed("outer", "inner")));
  CHECK(test::isRefusalOf("a.stl:6: ", "2 corners", changed("      vertex 0 0 0\n", "")));
  CHECK(
      test::isRefusalOf("a.stl:", "after endsolid", sentenceOfStl(text + "facet normal 0 0 1\n")));
}
