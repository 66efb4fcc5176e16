#include "formats/meshes/off_file.h"

#include <doctest/doctest.h>

#include "formats/meshes/cube_text.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "support/sentence.h"

using namespace resect;

namespace {

void checkOffCube(const std::string& text) {
  CAPTURE(text);
  const Model model = readOffFile("a.off", text);
  REQUIRE(model.parts.size() == 1);
  CHECK(topology(model.parts[0].mesh).closed());
  CHECK(volume(model.parts[0].mesh) == doctest::Approx(1));
}

const std::string kBody = test::cubePoints() + test::cubeFaces("3 ", 0);

}  // namespace

TEST_CASE("an .off is read with any first line that says the same") {
  for (const char* head : {"OFF\n8 12 0\n", "OFF 8 12 18\n", "off\n# a cube\n\n8 12\n", "8 12 0\n",
                           "\xef\xbb\xbfOFF\r\n8 12 0\r\n", "OFF # by hand\n8 12 0\n"})
    checkOffCube(head + kBody);
}

TEST_CASE("normals and colours of an .off are passed over, and so is what follows") {
  std::string points;
  for (const Vec3& p : test::cube().points)
    points += fmt::format("{} {} {} 0 0 1 255 0 0 255 # corner\n", p.x(), p.y(), p.z());
  std::string faces;
  for (const Triangle& t : test::kCubeTriangles)
    faces += fmt::format("3 {} {} {} 0.1 0.2 0.3\n", t[0], t[1], t[2]);
  checkOffCube("CNOFF\n8 12 0\n" + points + faces);
  checkOffCube("OFF\n8 12 0\n" + kBody + "anything at all");
  CHECK(startsAsOff("STCNOFF\n"));
  CHECK(startsAsOff("  OFF 8 12 0\n"));
  CHECK_FALSE(startsAsOff("OFFICE"));
  CHECK_FALSE(startsAsOff("solid OFF"));
}

TEST_CASE("a damaged .off is refused with its line") {
  const auto refuses = [](const std::string& text, const std::string& what) {
    const std::string sentence = test::sentenceOf([&] { readOffFile("a.off", text); });
    CHECK_MESSAGE(test::isRefusalOf("a.off:", what, sentence), sentence);
  };
  const std::string whole = "OFF\n8 12 0\n" + kBody;
  refuses(whole.substr(0, whole.size() - 20), "the file ends early");
  refuses("OFF\n8 12 0\n" + test::cubePoints(), "the file ends early");
  refuses("OFF\n8 900000 0\n" + kBody, "the file ends early: it promises 900000 faces");
  refuses("OFF\n-8 12 0\n" + kBody, "'-8'");
  refuses("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "face 0 uses point 3 of only 3");
  refuses("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n900 0 1 3\n", "900 corners");
  refuses("OFF\n3 1 0\n0 0 0\n1 0 x\n", "has 'x'");
  refuses("4OFF\n1 0 0\n0 0 0 0\n", "four or more dimensions");
  refuses("nOFF\n1 0 0\n0 0 0 0\n", "four or more dimensions");
  refuses("OFF BINARY\nxxxx", "binary");
}
