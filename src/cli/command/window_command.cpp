// resect window: interactive operation.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/language/language.h"
#include "app/window.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/text/file_stem.h"
#include "cli/command/commands.h"
#include "cli/organ_options.h"
#include "cli/picture_writer.h"
#include "cli/shared_options.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_files.h"

namespace resect {
namespace {

constexpr const char* kFirstScenario = "incise";  // of a window that is asked for no other

struct WindowCommandOptions {
  std::string scenario, organ, breathing, setting, language, size = "1280x800";
  double fpsLimit = 60;
  int threads = 0, history = 512;
  bool thesis = false, light = false, dark = false, reports = false, exercises = false;
};

void window(const WindowCommandOptions& options, const OrganOptions& organOptions) {
  WindowOptions window;
  parseSize(options.size, window.width, window.height);
  const ThreadLimit threads(options.threads);
  const std::filesystem::path given = options.scenario;
  if (given.extension() == ".resect") {
    if (!std::filesystem::is_regular_file(given))
      throw error("{}: there is no such recording; check the name", given.string());
    window.operation = given.string();
  }
  if (options.scenario.empty() && !options.thesis)
    window.scenario = readScenario(findDataFile(kFirstScenario, "scenarios", ".toml"));
  else if (!options.scenario.empty() && window.operation.empty())
    window.scenario = readScenario(findScenario(options.scenario));
  else if (options.thesis)
    window.scenario.organs[0].source.spacing = 0.005;
  const std::string own = window.scenario.organs[0].source.file;
  organOptions.applyTo(window.scenario, options.organ);
  if (!options.organ.empty() && options.organ != own) {  // its words are about another organ
    const std::string organ = fileStem(window.scenario.organs[0].source.file);
    window.scenario.title =
        options.scenario.empty() ? organ : fmt::format("{}: {}", fileStem(options.scenario), organ);
    window.scenario.description.clear();
  }
  requireSetting(options.setting);
  if (!options.setting.empty()) window.scenario.setting = options.setting;
  setBreathing(window.scenario, options.breathing);
  if (options.thesis) makeThesis(window.scenario);
  window.fpsLimit = options.fpsLimit;
  window.historyMemory = options.history;
  if (options.light || options.dark) window.dark = options.dark;
  window.language = options.language;
  window.reports = options.reports;
  window.exercises = options.exercises;
  if (const int status = showWindow(window); status != 0)
    throw error("the window ended with status {}", status);
}

}  // namespace

void addWindowCommand(Command app) {
  auto options = std::make_shared<WindowCommandOptions>();
  Command command = app.subcommand("window", "Operate with mouse and keyboard");
  command.option("SCENARIO", options->scenario,
                 "Organ and room of this scenario, or a recorded operation (*.resect) that goes "
                 "on; without it \"incise\", a liver in the opened abdomen, or the organ of "
                 "--organ on the table");
  command.option(
      "--organ", options->organ,
      "Another organ: model or file of particles, or a built-in one: " + builtInOrgans());
  auto organ = addOrganOptions(command);
  command.option("--threads", options->threads, "Threads to use; 0 = all")
      .range(0, 1024)
      .showDefault();
  command.option("--fps-limit", options->fpsLimit, "Most pictures per second")
      .range(1.0, 1000.0)
      .showDefault();
  command
      .option("--history", options->history,
              "Memory for showing earlier moments of the operation, MB")
      .range(16, 1 << 20)
      .showDefault();
  command.option("--size", options->size, "Width and height of the window, pixels").showDefault();
  addSettingOption(command, options->setting);
  addBreathingOption(command, options->breathing);
  command.flag("--thesis", options->thesis,
               "As the original system: tissue is still, instruments take out what they touch");
  const Option light = command.flag("--light", options->light, "Light colours");
  command.flag("--dark", options->dark, "Dark colours; neither: as chosen last").excludes(light);
  command
      .option(
          "--language", options->language,
          "Language of the window: en or de; else as chosen in View > Language, or the system's")
      .oneOf(languageCodes());
  command.flag("--exercises", options->exercises, "Begin with the list of exercises");
  command.flag("--reports", options->reports,
               "Say on standard output what happens and where things are, for scripts");
  command.footer(
      "Examples:\n"
      "  resect window\n"
      "  resect window --organ my_liver.stl --unit mm --spacing 6mm\n"
      "  resect window cut-950\n"
      "  resect window --exercises\n"
      "  resect window operation.resect");
  command.action([options, organ] { window(*options, *organ); });
}

}  // namespace resect
