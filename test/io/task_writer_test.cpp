// Exercises that are written are the exercises that are read.
#include "io/scenario/task_writer.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_reader.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

Scenario shipped(const std::string& name) {
  return readScenario(dataFolder() / "tasks" / (name + ".toml"));
}

Scenario writtenAndRead(const Scenario& scenario, const std::filesystem::path& file) {
  std::ofstream(file) << exerciseText(scenario);
  return readScenario(file);
}

void checkSame(const TaskGoal& a, const TaskGoal& b) {
  CHECK(a.kind == b.kind);
  CHECK(a.structure == b.structure);
  CHECK(a.with == b.with);
  CHECK(a.holdWith == b.holdWith);
  CHECK(a.vessel == b.vessel);
  CHECK(a.radius == doctest::Approx(b.radius));
  CHECK(a.hold == doctest::Approx(b.hold));
  CHECK(a.margin == doctest::Approx(b.margin));
  CHECK(a.rate == doctest::Approx(b.rate));
  CHECK(a.from == doctest::Approx(b.from));
  CHECK(a.thinnest == doctest::Approx(b.thinnest));
  CHECK((a.normal - b.normal).norm() < 1e-5);
  REQUIRE(a.places.size() == b.places.size());
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    CHECK((a.places[i].place - b.places[i].place).norm() < 1e-5);
    CHECK(a.places[i].depth == b.places[i].depth);
    CHECK(a.places[i].inWorld == b.places[i].inWorld);
    CHECK(a.places[i].landmark == b.places[i].landmark);
  }
}

void checkSame(const std::vector<TaskLimit>& a, const std::vector<TaskLimit>& b) {
  REQUIRE(a.size() == b.size());
  for (const TaskLimit& limit : b) {
    const auto at = std::ranges::find(a, limit.measure, &TaskLimit::measure);
    REQUIRE(at != a.end());
    CHECK(at->most == limit.most);
    CHECK(at->least == limit.least);
  }
}

void checkSame(const std::vector<ToolKey>& a, const std::vector<ToolKey>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].time == doctest::Approx(b[i].time));
    CHECK((a[i].pose.position - b[i].pose.position).norm() < 1e-6);
    CHECK(angleBetween(a[i].pose.rotation, b[i].pose.rotation) < 1e-5);
    CHECK(a[i].squeeze == doctest::Approx(b[i].squeeze));
    CHECK(a[i].pedal == doctest::Approx(b[i].pedal));
  }
}

}  // namespace

TEST_CASE("each shipped task is the same after it was written and read") {
  const test::TemporaryFolder folder;
  for (const std::string& name : shippedNames("tasks", ".toml")) {
    CAPTURE(name);
    const Scenario before = shipped(name);
    const Scenario after = writtenAndRead(before, folder / (name + ".toml"));
    REQUIRE(after.task.has_value());
    checkSame(after.task->goal, before.task->goal);
    CHECK(after.task->teaches == before.task->teaches);
    CHECK(after.task->steps == before.task->steps);
    CHECK(after.task->instruments == before.task->instruments);
    CHECK(after.task->undo == before.task->undo);
    CHECK(after.task->forceLimit == before.task->forceLimit);
    checkSame(after.task->limits, before.task->limits);
    for (const TaskLevel level : kTaskLevels)
      checkSame(after.task->levels[std::size_t(level)], before.task->levels[std::size_t(level)]);
    CHECK(after.task->published == before.task->published);
    CHECK(after.task->pass == before.task->pass);
    CHECK(after.title == before.title);
    REQUIRE(after.tools.size() == before.tools.size());
    for (std::size_t t = 0; t < before.tools.size(); ++t)
      checkSame(after.tools[t].keys, before.tools[t].keys);
    for (const ScenarioTool& tool : before.tools)
      CHECK((tool.keys.empty() || after.duration > tool.keys.back().time));
    const OrganSource &a = after.organs[0].source, &b = before.organs[0].source;
    CHECK(a.spacing == b.spacing);
    CHECK(a.vessels == b.vessels);
    CHECK((a.pose.position - b.pose.position).norm() < 1e-12);
    REQUIRE(a.labels.size() == b.labels.size());
    for (std::size_t i = 0; i < a.labels.size(); ++i) {
      CHECK(a.labels[i].name == b.labels[i].name);
      CHECK((a.labels[i].region.centre - b.labels[i].region.centre).norm() < 1e-6);
      CHECK(a.labels[i].region.radius == doctest::Approx(b.labels[i].region.radius));
    }
  }
}

TEST_CASE(
    "what is unusual is written too: quotation marks, other cells, a tumour, a file of its own") {
  const test::TemporaryFolder folder;
  Scenario scenario = readScenario(dataFolder() / "scenarios" / "incise.toml");
  scenario.title = "The \"last\" one\\two";
  scenario.organs[0].source.spacing = 0.012;
  OrganLabel tumour{3, "tumour", {}};
  tumour.region.shape = Region::Shape::Ball;
  tumour.region.frame = Region::Frame::Organ;
  tumour.region.centre = {0.5, 0.5, 0.25};
  tumour.region.radius = 0.01;
  scenario.organs[0].source.labels.push_back(tumour);
  scenario.task.emplace();
  scenario.task->teaches = "Nothing.";
  scenario.task->goal.kind = TaskGoal::Kind::Resect;
  scenario.task->goal.structure = "tumour";
  scenario.task->bands = {{"path_length_m", 0.92, 0.08}, {"movements", 7, 1.5}};
  scenario.task->bandRuns = 4;
  const Scenario after = writtenAndRead(scenario, folder / "own.toml");
  CHECK(after.title == scenario.title);
  CHECK(test::bytesOf(folder / "own.toml").find("spacing = 0.012\n") != std::string::npos);
  CHECK(after.organs[0].source.spacing == 0.012);
  REQUIRE(after.organs[0].source.labels.size() == 1);
  CHECK(after.organs[0].source.labels[0].region.frame == Region::Frame::Organ);
  CHECK(after.organs[0].source.labels[0].label == 3);
  CHECK(after.organs[0].tissue.elastic == scenario.organs[0].tissue.elastic);
  CHECK(after.task->goal.structure == "tumour");
  REQUIRE(after.task->bands.size() == 2);
  CHECK(after.task->bandRuns == 4);
  for (const TaskBand& band : after.task->bands) {
    CHECK(band.mean == (band.measure == "movements" ? 7 : 0.92));
    CHECK(band.deviation == (band.measure == "movements" ? 1.5 : 0.08));
  }

  scenario.file = folder / "none.toml";
  CHECK(test::sentenceOf([&] { exerciseText(scenario); }).find("no such file") !=
        std::string::npos);
}

TEST_CASE("a bleeding that is to be stopped is one that bleeds: its two rates") {
  const Scenario scenario = shipped("control-bleeding");
  const auto with = [&](const std::string& rates) {
    return parseTask("teaches = \"x\"\ngoal = {kind = \"stop-bleeding\"" + rates + "}", "a task",
                     scenario);
  };
  CHECK(60e6 * with("").goal.rate == doctest::Approx(5));
  CHECK(60e6 * with("").goal.from == doctest::Approx(20));
  CHECK(60e6 * with(", rate_ml_min = 10").goal.from == doctest::Approx(40));
  CHECK(60e6 * with(", from_ml_min = 100").goal.from == doctest::Approx(100));
  CHECK(test::sentenceOf([&] {
          with(", rate_ml_min = 10, from_ml_min = 8");
        }).find("goal.from_ml_min") != std::string::npos);
  CHECK(!with("").forceLimit);
  CHECK(60e6 * scenario.task->goal.from >= 4 * 60e6 * scenario.task->goal.rate);
}

TEST_CASE("a task at another level keeps the level in its text") {
  const Scenario scenario = shipped("touch-and-hold");
  const Task hard = atLevel(*scenario.task, TaskLevel::Hard);
  CHECK(hard.level == TaskLevel::Hard);
  const Task again = parseTask(hard.text, "its text", scenario);
  CHECK(again.level == TaskLevel::Hard);
  checkSame(again.goal, scenario.task->goal);
  CHECK(limitsAt(again, again.level)[0].most !=
        limitsAt(*scenario.task, TaskLevel::Medium)[0].most);
}
