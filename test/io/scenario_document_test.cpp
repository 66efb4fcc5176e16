// docs/scenarios.md agrees with the reader.
#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/primitives.h"
#include "io/scenario/scenario_file.h"

using namespace resect;

namespace {

std::string document() {
  std::ifstream in(std::string(RESECT_SOURCE_DIR) + "/docs/scenarios.md");
  REQUIRE(in.good());
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

// The blocks fenced as TOML, in order.
std::vector<std::string> examples() {
  const std::string text = document(), open = "```toml\n";
  std::vector<std::string> blocks;
  for (auto at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const auto begin = at + open.size();
    blocks.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  REQUIRE(blocks.size() == 3);
  return blocks;
}

}  // namespace

TEST_CASE("the complete scenario of the documentation is read, with its instruments in hand") {
  const Scenario scenario = parseScenario(examples()[0], "document");
  CHECK(*scenario.organs[0].source.spacing == 0.005);
  REQUIRE(scenario.tools.size() == 3);
  CHECK(scenario.tools[0].keys.size() == 3);
  CHECK(toolInputAt(scenario.tools[0], 1.5).inHand);
  CHECK(scenario.tools[2].rest.position == Vec3(-0.25, 0.01, 0));
  CHECK(frameCount(scenario) == 180);
}

TEST_CASE("the way of the documentation is read") {
  const Scenario scenario =
      parseScenario("title = \"Way\"\nafter = 0.5\n" + examples()[1], "document");
  REQUIRE(scenario.tools[0].way);
  CHECK(scenario.tools[0].way->keys.size() == 5);
}

TEST_CASE("the instrument of the documentation is read") {
  const auto file = std::filesystem::temp_directory_path() / "resect_document_tool.toml";
  std::ofstream(file) << examples()[2];
  const ToolModel tool = readTool(file, [](const std::filesystem::path&) {
    return boxMesh({{0, 0, 0}, {1, 1, 1}});
  });
  std::filesystem::remove(file);
  CHECK(tool.kind == "scalpel");
  CHECK(tool.edge.size() == 3);
}

TEST_CASE("every key that the reader knows is in the documentation's tables") {
  // A key that nobody knows makes the reader list those that it does know.
  const auto known = [](const std::string& text) {
    try {
      parseScenario(text, "x");
    } catch (const Error& e) {
      const std::string sentence = e.what(), before = "known are: ";
      const auto at = sentence.find(before);
      REQUIRE(at != std::string::npos);
      return sentence.substr(at + before.size());
    }
    return std::string();
  };
  const std::string start = "title = \"t\"\nduration = 1\n", text = document();
  int keys = 0;
  for (const char* nobodys :
       {"x = 1\n", "[organ]\nx = 1\n", "[room]\nx = 1\n", "[[tool]]\nmodel = \"hook\"\nx = 1\n"}) {
    std::istringstream names(known(start + nobodys));
    for (std::string name; names >> name; ++keys) {
      if (name.back() == ',') name.pop_back();
      const bool described = text.find("| `" + name + "` |") != std::string::npos ||
                             text.find("## `[" + name + "]`") != std::string::npos ||
                             text.find("## `[[" + name + "]]`") != std::string::npos;
      CHECK_MESSAGE(described, "docs/scenarios.md does not describe " << name);
    }
  }
  CHECK(keys > 20);
}
