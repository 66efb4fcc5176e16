// resect task: the tasks that come with Resect, and the check of one's own.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <memory>
#include <ostream>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/progress_bar.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/output/atomic_file.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_files.h"
#include "skills/attempt/goal_places.h"
#include "skills/attempt/goal_watch.h"
#include "skills/report/task_page.h"
#include "skills/score/bands.h"
#include "skills/score/goal_result.h"

namespace resect {
namespace {

Scenario taskScenario(const std::string& name) {
  Scenario scenario = readScenario(findScenario(name));
  if (!scenario.task)
    throw error("{}: has no task; add a table [task], as docs/how-to/make_a_task.md shows",
                scenario.file);
  return scenario;
}

void list(bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const std::string& name : shippedNames("tasks", ".toml")) {
    const Scenario scenario = taskScenario(name);
    const Task& task = *scenario.task;
    all.push_back({{"scenario", name},
                   {"title", scenario.title},
                   {"level", wordOf(task.level)},
                   {"goal", wordOf(task.goal.kind)},
                   {"teaches", task.teaches}});
    if (!json)
      printLine(stdout, "{:<20} {:<7} {}: {}", name, wordOf(task.level), scenario.title,
                task.teaches);
  }
  if (json) writeJson("-", all);
}

// Reads the file as a run does, makes the organ, and finds what the task names in it.
void check(const std::string& file) {
  Scenario scenario = taskScenario(file);
  const Task& task = *scenario.task;
  for (const std::string& band : task.published) readPublishedStudy(band);
  std::vector<std::string> notes;
  const std::vector<OperatedOrgan> organs =
      loadOrgans(scenario, modelReader(), progressBar("particles"), &notes);
  const OperatedOrgan& organ = organs[goalOrgan(task.goal, scenario)];
  requireFits(task.goal, organ);
  loadTools(scenario, modelReader());
  printNotes(stderr, notes);
  printLine(stdout, "{}: {}", scenario.file, scenario.title);
  printLine(stdout, "  goal    {}", goalSentence(task));
  for (const TissuePoint& point : goalPlaces(task.goal.places, organ.organ))
    printLine(stdout, "  place   {:.3f} {:.3f} {:.3f} m", point.rest.x() + 0.0,
              point.rest.y() + 0.0, point.rest.z() + 0.0);
  for (const TaskLevel level : kTaskLevels)
    printLine(stdout, "  {:<7} {} limits{}", wordOf(level), limitsAt(task, level).size(),
              level == task.level ? ", unless another level is asked for" : "");
}

void show(const std::string& file, const std::string& output) {
  const Scenario scenario = taskScenario(file);
  const std::vector<std::filesystem::path> inputs{scenario.file};
  checkOutputs({{{"--output", output}}}, inputs);
  const std::string page = taskPage(scenario);
  writeFileAtomically(output, [&](std::ostream& out) { out << page; });
}

}  // namespace

void addTaskCommand(Command app) {
  Command command = app.subcommand("task", "List exercises, and check one of your own");
  command.requireSubcommand();
  auto json = std::make_shared<bool>(false);
  Command lister = command.subcommand("list", "List the tasks that come with Resect");
  lister.flag("--json", *json, "Print JSON");
  lister.action([json] { list(*json); });
  auto file = std::make_shared<std::string>();
  Command checker = command.subcommand("check", "Check a scenario with a task");
  checker.option("FILE", *file, "Scenario file, or the name of a task that comes with Resect")
      .required();
  checker.action([file] { check(*file); });
  auto shown = std::make_shared<std::array<std::string, 2>>();
  Command shower = command.subcommand("show", "Write a page of what an exercise teaches");
  shower.option("FILE", (*shown)[0], "Scenario file, or the name of a task that comes with Resect")
      .required();
  shower.option("-o,--output", (*shown)[1], "HTML page (.html)").required();
  shower.action([shown] { show((*shown)[0], (*shown)[1]); });
  command.footer(
      "Examples:\n  resect task list\n  resect task show two-hands -o two_hands.html\n  resect "
      "task check my_task.toml");
}

}  // namespace resect
