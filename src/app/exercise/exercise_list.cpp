#include "app/exercise/exercise_list.h"

#include <QSettings>
#include <QStringList>
#include <algorithm>

#include "base/error.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"

namespace resect {
namespace {

constexpr const char* kOwn = "exercises";  // in the settings: files of the user

Exercise exerciseOf(const std::filesystem::path& file) {
  const Scenario scenario = readScenario(file);
  if (!scenario.task)
    throw error("{}: has no task, so it is no exercise; choose a file with a table [task]",
                file.string());
  std::filesystem::path picture = file;
  return {file, picture.replace_extension(".png"), scenario.name, scenario.title, *scenario.task};
}

}  // namespace

std::vector<Exercise> allExercises(std::vector<std::string>& complaints) {
  std::vector<std::filesystem::path> files;
  for (const QString& own : QSettings().value(kOwn).toStringList())
    files.emplace_back(own.toStdString());
  for (const std::string& name : shippedNames("tasks", ".toml"))
    files.push_back(dataFolder() / "tasks" / (name + ".toml"));
  std::vector<Exercise> exercises;
  for (const std::filesystem::path& file : files) try {
      exercises.push_back(exerciseOf(file));
    } catch (const Error& e) {
      complaints.push_back(e.what());
    }
  return exercises;
}

void addExercise(const std::filesystem::path& file) {
  const std::filesystem::path whole = std::filesystem::absolute(file);
  exerciseOf(whole);
  QSettings settings;
  QStringList own = settings.value(kOwn).toStringList();
  own.removeAll(QString::fromStdString(whole.string()));
  own.prepend(QString::fromStdString(whole.string()));
  settings.setValue(kOwn, own);
}

Scenario asExercise(Scenario scenario) {
  if (!scenario.task || scenario.task->instruments.empty()) return scenario;
  const Task& task = *scenario.task;
  std::erase_if(scenario.tools, [&](const ScenarioTool& tool) {
    const std::string model = modelOf(tool);
    return std::ranges::count(task.instruments, model) == 0 && model != task.goal.with &&
           model != task.goal.holdWith;
  });
  return scenario;
}

}  // namespace resect
