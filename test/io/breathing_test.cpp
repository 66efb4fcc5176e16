// [breathing] in scenario files.
#include <doctest/doctest.h>

#include "io/scenario/scenario_file.h"
#include "support/sentence.h"

using namespace resect;

namespace {

Scenario parsed(const std::string& breathing, const std::string& model = "elastic") {
  return parseScenario("title = \"x\"\nduration = 1\n[tissue]\nmodel = \"" + model +
                           "\"\n[breathing]\n" + breathing + "\n",
                       "x.toml");
}
std::string complaintOfBreathing(const std::string& breathing,
                                 const std::string& model = "elastic") {
  return test::sentenceOf([&] { parsed(breathing, model); });
}

}  // namespace

TEST_CASE("a scenario says how the patient breathes") {
  const Breathing b =
      parsed("depth = \"12mm\"\nper_minute = 15\nbed = 0.5\nbegins = false").breathing;
  CHECK(b.depth == 0.012);
  CHECK(b.perMinute == 15);
  CHECK(b.bed == 0.5);
  CHECK(!b.begins);
  const Breathing usual = parsed("depth = 0.01").breathing;
  CHECK(usual.depth == 0.01);
  CHECK(usual.perMinute == 12);
  CHECK(usual.begins);
  CHECK(parseScenario("title = \"x\"\nduration = 1\n", "x.toml").breathing.depth == 0);
  CHECK(parsed("depth = 0", "still").breathing.depth == 0);
}

TEST_CASE("breathing that nobody breathes is refused with file, line and key") {
  for (const char* wrong :
       {"depth = -0.01", "depth = \"200mm\"", "depth = \"deep\"", "depth = nan",
        "depth = 0.01\nper_minute = 1000", "depth = 0.01\nper_minute = 0",
        "depth = 0.01\nper_minute = -12", "depth = 0.01\nbed = 1.5", "depth = 0.01\nbegins = 1",
        "per_minute = 12", "depth = 0.01\nrate = 12"}) {
    CAPTURE(wrong);
    const std::string sentence = complaintOfBreathing(wrong);
    CAPTURE(sentence);
    CHECK(test::isRefusalOf("x.toml:", "", sentence));
  }
  CHECK(test::tells(complaintOfBreathing("depth = \"200mm\""), "60 mm"));
  CHECK(test::tells(complaintOfBreathing("depth = 0.01\nper_minute = 1000"), "60"));
  CHECK(test::tells(complaintOfBreathing("depth = 0.01", "still"), "elastic"));
}

TEST_CASE("breathing that a program sets is checked as well") {
  Scenario scenario = parsed("depth = 0.01");
  CHECK(test::refuses([&] { setBreathing(scenario, 0.2); }, "0.06"));
  CHECK(test::refuses([&] { setBreathing(scenario, -0.01); }, "0.06"));
  setBreathing(scenario, 0.02);
  CHECK(scenario.breathing.depth == 0.02);
  offerBreathing(scenario);  // it breathes already
  CHECK(scenario.breathing.begins);
  scenario.breathing.perMinute = 1000;
  CHECK(test::refuses([&] { requireSound(scenario); }, "a minute"));
  makeStill(scenario);
  CHECK(test::refuses([&] { setBreathing(scenario, 0.01); }, "elastic"));
  scenario.breathing.depth = 0;
  offerBreathing(scenario);  // nothing would move
  CHECK(scenario.breathing.depth == 0);
  makeElastic(scenario);
  offerBreathing(scenario);
  CHECK(scenario.breathing.depth == 0.01);
  CHECK(!scenario.breathing.begins);
}
