#include "io/scenario/scenario_file.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"
#include "base/random.h"
#include "support/malformed/refused_scenario.h"
#include "support/malformed/replaced.h"

using namespace resect;
using test::complaintOfScenario;
using test::replaced;

namespace {

const char* kGood = R"(title = "A cut"
duration = 2.5
frame_rate = 30
close_up = [[0.1, 0, -0.1], [0, 0.2, 0.1]]
[organ]
source = "liver"
spacing = "4mm"
iso = 45
[[tool]]
model = "scalpel"
keys = [
  { time = 0.5, position = [0, 0.1, 0], rotation = { handle = [0, 1, 0], edge = [0, 0, 1] } },
  { time = 1.5, position = [0, 0.0, 0], rotation = { axis = [1, 0, 0], degrees = 90 } },
]
)";

}  // namespace

TEST_CASE("a scenario file says what it says") {
  const Scenario s = parseScenario(kGood, "cut");
  CHECK(s.title == "A cut");
  CHECK(s.duration == 2.5);
  CHECK(s.frameRate == 30);
  REQUIRE(s.closeUp);
  CHECK(s.closeUp->min == Vec3(0, 0, -0.1));
  CHECK(s.closeUp->max == Vec3(0.1, 0.2, 0.1));
  CHECK(*s.organs[0].source.spacing == 0.004);
  CHECK(s.organs[0].source.settings.iso == 45);
  REQUIRE(s.tools.size() == 1);
  REQUIRE(s.tools[0].keys.size() == 2);
  // Handle (+Z of the tool) up, edge (-Y of the tool) towards +Z.
  const Eigen::Quaterniond q = s.tools[0].keys[0].pose.rotation;
  CHECK((q * Vec3(0, 0, 1) - Vec3(0, 1, 0)).norm() < 1e-12);
  CHECK((q * Vec3(0, -1, 0) - Vec3(0, 0, 1)).norm() < 1e-12);
  const Eigen::Quaterniond r = s.tools[0].keys[1].pose.rotation;
  CHECK((r * Vec3(0, 1, 0) - Vec3(0, 0, 1)).norm() < 1e-12);
}

TEST_CASE("a wrong scenario file is refused with file, line and key") {
  CHECK(complaintOfScenario(replaced(kGood, "duration = 2.5", "duration = -1")) ==
        "x.toml:2: duration is no number from 0.001 to 3600");
  CHECK(complaintOfScenario(replaced(kGood, "iso = 45", "iso = 200"))
            .find("x.toml:8: organ.iso is no number") == 0);
  CHECK(complaintOfScenario(replaced(kGood, "iso = 45", "isso = 45"))
            .find("x.toml:8: organ.isso is not known here") == 0);
  CHECK(complaintOfScenario(replaced(kGood, "\"4mm\"", "\"4 parsec\""))
            .find("x.toml:7: organ.spacing is") == 0);
  CHECK(complaintOfScenario(replaced(kGood, "time = 1.5", "time = 0.5")).find("is not later") !=
        std::string::npos);
  CHECK(complaintOfScenario(replaced(kGood, "[0, 0.1, 0]", "[0, 0.1]"))
            .find("three finite numbers") != std::string::npos);
  CHECK(complaintOfScenario(replaced(kGood, "[0, 0.1, 0]", "[0, nan, 0]"))
            .find("three finite numbers") != std::string::npos);
  CHECK(complaintOfScenario(replaced(kGood, "edge = [0, 0, 1]", "edge = [0, 2, 0]"))
            .find("different directions") != std::string::npos);
  CHECK(complaintOfScenario(replaced(kGood, "title = \"A cut\"", "")).find("title is missing") !=
        std::string::npos);
  CHECK(complaintOfScenario(replaced(kGood, ", [0, 0.2, 0.1]]", "]"))
            .find("x.toml:4: close_up is missing or") == 0);
  CHECK(complaintOfScenario(replaced(kGood, "[0, 0.2, 0.1]", "[0.1, 0, -0.1]")) ==
        "x.toml:4: close_up has no size");
  CHECK(complaintOfScenario(std::string(kGood) + "[room]\nsetting = \"beach\"\n")
            .find("room.setting is \"beach\"; choose table or field") != std::string::npos);
  CHECK(complaintOfScenario("title = ").find("x.toml:1:") == 0);
  CHECK(complaintOfScenario(std::string(100000, '[')).find("nested") != std::string::npos);
}

TEST_CASE("what is wrong is told with its line, after texts of lines and whatever ends the lines") {
  const std::string text =
      "title = \"\"\"\nA cut\n\"\"\"\nduration = 1\n[[organ]]\nname = \"a\"\n[[organ]]\nname = "
      "\"b\"\n"
      "beside = \"c\"\n[[tool]]\nmodel = \"hook\"\nkeys = [\n  { time = 0, position = [0, 0, 0] "
      "},\n\n"
      "  { time = 1, position = [0, 0, 101] },\n]\n";
  CHECK(complaintOfScenario(text) ==
        "x.toml:9: organ[2].beside is \"c\", which is no organ before this one");
  const std::string second = replaced(text, "\"c\"", "\"a\"");
  std::string windows;
  for (const char c : second) windows += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& file : {second, windows})
    CHECK(complaintOfScenario(file) ==
          "x.toml:15: tool[1].keys[2].position is not three finite numbers [x, y, z] from -100 to "
          "100");
}

TEST_CASE("an empty text where a name is meant is refused with its line") {
  for (const char* line : {"title = \"A cut\"", "source = \"liver\"", "model = \"scalpel\""}) {
    const std::string key = std::string(line).substr(0, std::string(line).find(' '));
    for (const char* empty : {" = \"\"", " = \"  \"", " = ''"}) {
      const std::string sentence = complaintOfScenario(replaced(kGood, line, key + empty));
      CHECK_MESSAGE(sentence.find(key + " is empty; give a text") != sentence.npos, sentence);
    }
  }
  const std::string nameless =
      complaintOfScenario(std::string(kGood) + "[organ.landmark]\n\"\" = [0, 0, 0]\n");
  CHECK_MESSAGE(nameless.find("is a place without a name") != nameless.npos, nameless);
  CHECK(parseScenario("title = \"A\"\nduration = 1\ndescription = \"\"\n", "x.toml")
            .description.empty());
}

TEST_CASE("a scenario file with any bytes changed is read or refused in one line, never worse") {
  Random random(5);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = kGood;
    for (int n = 1 + random.below(4); n > 0; --n) {
      const auto at = std::size_t(random.below(int(text.size())));
      switch (random.below(3)) {
        case 0:
          text[at] = char(random.below(256));
          break;
        case 1:
          text.erase(at, std::size_t(random.below(30)));
          break;
        default:
          text.insert(at, 1, "[]{}=\"',.\n-e9"[random.below(13)]);
      }
    }
    try {
      parseScenario(text, "x.toml");
    } catch (const Error& e) {
      ++refused;
      REQUIRE(std::string(e.what()).size() > 10);
      REQUIRE(std::string(e.what()).find('\n') == std::string::npos);
    }
  }
  CHECK(refused > 500);
}
