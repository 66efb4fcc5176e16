#include "io/scenario/way_reader.h"

#include <doctest/doctest.h>

#include "io/scenario/scenario_file.h"
#include "support/malformed/refused_scenario.h"

using namespace resect;

namespace {

std::string tool(const std::string& keys, const std::string& more = "") {
  return "title = \"Way\"\nafter = 0.5\n[[tool]]\nmodel = \"scalpel\"\nframe = \"organ\"\n" + more +
         "keys = [" + keys + "]\n";
}

const std::string kFirst = "{ time = 0.5, over = [0.5, 0.1], depth = \"-50mm\" }";

}  // namespace

TEST_CASE("a tool's way in the organ's coordinates is read") {
  const Scenario scenario = parseScenario(
      tool(kFirst + ", { speed = 0.1, at = \"dome\", depth = \"40%\", squeeze = 0.5 },"
                    " { wait = 0.2 }, { speed = 1, position = [0, 1.5, 1], offset = [0, 0.01, 0],"
                    " cells = [0.5, 0, 0], pedal = 1 }"),
      "way.toml");
  REQUIRE(scenario.tools[0].way);
  CHECK(scenario.tools[0].keys.empty());
  CHECK(*scenario.after == 0.5);
  const std::vector<WayKey>& keys = scenario.tools[0].way->keys;
  REQUIRE(keys.size() == 4);
  CHECK(*keys[0].time == 0.5);
  CHECK(keys[0].kind == WayKey::Place::Over);
  CHECK(keys[0].place == Vec3(0.5, 0, 0.1));
  CHECK(*keys[0].depth == doctest::Approx(-0.05));
  CHECK_FALSE(keys[0].share);
  CHECK(keys[1].landmark == "dome");
  CHECK(keys[1].share);
  CHECK(*keys[1].depth == doctest::Approx(0.4));
  CHECK(keys[1].squeeze == 0.5);
  CHECK(keys[2].kind == WayKey::Place::Same);
  CHECK(keys[2].wait == 0.2);
  CHECK(keys[3].kind == WayKey::Place::Box);
  CHECK(keys[3].offset == Vec3(0, 0.01, 0));
  CHECK(keys[3].cells == Vec3(0.5, 0, 0));
  CHECK(keys[3].pedal == 1);
}

TEST_CASE("a wrong way is an error that says what to give") {
  const auto says = [](const std::string& text, const std::string& what) {
    const std::string sentence = test::complaintOfScenario(text, "way.toml");
    CAPTURE(sentence);
    CHECK(sentence.find(what) != sentence.npos);
    CHECK(sentence.find("way.toml") != sentence.npos);
  };
  says(tool(""), "there are no keys");
  says(tool("{ speed = 1, over = [0, 0], depth = 0 }"), "the first key of an instrument needs one");
  says(tool("{ time = 1 }"), "give position, at or over");
  says(tool(kFirst + ", { over = [0, 0], depth = 0 }"), "give time, speed or wait");
  says(tool(kFirst + ", { time = 1, speed = 1 }"), "give time, speed or wait");
  says(tool(kFirst + ", { time = 0.4 }"), "is not later than that of the key before");
  says(tool("{ time = 1, over = [0.5, 0.5] }"), "give how deep below the organ's top");
  says(tool("{ time = 1, over = [0.5], depth = 0 }"), "is not two fractions");
  says(tool("{ time = 1, over = [0.5, 0.5], depth = \"x%\" }"),
       "is no share of the organ's height");
  says(tool("{ time = 1, over = [0.5, 0.5], at = \"a\", depth = 0 }"), "only one of them");
  says(tool(kFirst + ", { wait = 1, depth = 0.1 }"), "without a place");
  says(tool(kFirst + ", { wait = 1, deep = 0.1 }"), "deep");
  says(tool(kFirst, "organ = \"heart\"\n"), "is no organ of the scenario");
  says("duration = 1\n" + tool(kFirst), "keep one");
  says("title = \"a\"\nduration = 1\n[[tool]]\nmodel = \"scalpel\"\nframe = \"room\"\n",
       "use \"world\" or \"organ\"");
}
