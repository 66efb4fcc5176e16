// resect run: an operation from a scenario file, headless, with pictures, surfaces and a summary.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/picture_writer.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/run_report.h"
#include "cli/shared_options.h"
#include "formats/beside_files.h"
#include "io/data_folder.h"
#include "io/mesh_file.h"
#include "io/operation_setup.h"
#include "io/output/atomic_file.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/scenario_files.h"
#include "io/scenario/task_files.h"
#include "operation/promises.h"
#include "operation/run.h"
#include "organ/parts/bodies.h"
#include "record/recorder.h"

namespace resect {
namespace {

struct RunOptions {
  std::string scenario, organ, breathing, record, surface, pieces, plot, json;
  std::vector<std::string> without;  // instruments
  PictureOptions pictures;
  int threads = 0;
  bool list = false, thesis = false, overwrite = false, strict = false;
};

NumberedOutputs piecesOf(const RunOptions& options) {
  return {"--pieces", options.pieces, "piece_", ".stl"};
}

void listScenarios() {
  for (const std::string& name : shippedNames("scenarios", ".toml"))
    printLine(stdout, "{:<24} {}", name,
              readScenario(dataFolder() / "scenarios" / (name + ".toml")).title);
}

// Takes instruments out of the scenario's hands.
void leaveOnTray(Scenario& scenario, const std::vector<std::string>& instruments) {
  for (const std::string& name : instruments) {
    const auto tool = std::ranges::find(scenario.tools, name, &ScenarioTool::model);
    if (tool == scenario.tools.end()) {
      std::string known;
      for (const ScenarioTool& t : scenario.tools) known += (known.empty() ? "" : ", ") + t.model;
      throw usageError("--without names \"{}\", which this scenario does not have; it has {}", name,
                       known);
    }
    tool->keys.clear();
  }
}

std::vector<std::string> writePieces(const RunOptions& options, const Simulation& simulation) {
  const NumberedOutputs pieces = piecesOf(options);
  if (options.overwrite) removeNumberedFiles(pieces);
  std::vector<std::string> files;
  for (const OperatedOrgan& o : simulation.organs())
    for (const Body& body : bodies(o.organ, o.organ.surface.mesh(o.points()))) {
      if (body.particles == 0) continue;  // a fragment of the surface, which holds no tissue
      files.push_back(pieces.folder /
                      fmt::format("{}{}{}", pieces.before, files.size() + 1, pieces.extension));
      writeMeshFile(files.back(), body.mesh);
    }
  return files;
}

void checkOptions(const RunOptions& options) {
  options.pictures.check();
  if (!options.surface.empty()) checkWritableMeshFile(options.surface);
}

void checkFiles(const RunOptions& options, const Scenario& scenario) {
  std::vector<std::filesystem::path> inputs = filesRead(scenario);
  addFilesBeside(inputs);
  checkOutputs({{{"--surface", options.surface},
                 {"--video", options.pictures.video},
                 {"--plot", options.plot},
                 {"--json", options.json},
                 {"--record", options.record}},
                {framesIn(options.pictures.frames), piecesOf(options)},
                options.overwrite},
               inputs);
  if (!options.record.empty()) Database::requireNothingAt(options.record);
}

void run(const RunOptions& options, const OrganOptions& organOptions) {
  if (options.list) return listScenarios();
  if (options.scenario.empty())
    throw usageError("no scenario given; name one, or see what there is with resect run --list");
  checkOptions(options);
  const ThreadLimit threads(options.threads);

  Scenario scenario = readScenario(findScenario(options.scenario));
  organOptions.applyTo(scenario, options.organ);
  leaveOnTray(scenario, options.without);
  options.pictures.applyTo(scenario);
  setBreathing(scenario, options.breathing);
  if (options.thesis) {
    makeThesis(scenario);
    scenario.promises.clear();  // of instruments that act by their working parts
  }
  if (!options.plot.empty() && !moves(scenario))
    throw usageError(
        "--plot shows forces, and the tissue of \"{}\" does not move; leave it out, or "
        "set model = \"elastic\" in the scenario's [tissue]",
        scenario.name);
  checkFiles(options, scenario);

  std::vector<std::string> notes, files;
  Simulation simulation = makeSimulation(scenario, modelReader(), progressBar("particles"), &notes);

  // Before the frames, since they may say that these take long.
  std::FILE* text =
      isStandardOutput(options.json) ? stderr : placeForText({options.surface, options.plot});
  printNotes(text, notes);
  std::fflush(text);

  std::optional<PictureWriter> pictures;
  if (options.pictures.wanted())
    pictures.emplace(scenario, simulation, settingsOf(options.pictures, options.overwrite));
  std::optional<Recorder> recorder;  // after the pictures, which may not be possible here
  if (!options.record.empty()) recorder.emplace(options.record, scenario, simulation);

  const Progress progress = progressBar(scenario.name);
  const double frames = double(frameCount(scenario));
  const RunSummary summary =
      runScenario(simulation, scenario,
                  [&](const Simulation& now, const FrameInput& input, const StepReport& step) {
                    if (recorder) recorder->record(input, step, now);
                    if (pictures) pictures->follow(now, step);
                    report(progress, double(step.frame + 1) / frames);
                    return true;
                  });

  if (recorder) {
    recorder->stood({0, simulation.frame()}, simulation);
    recorder->finish();
    files.push_back(options.record);
  }
  if (pictures) {
    const auto written = pictures->finish();
    files.insert(files.end(), written.begin(), written.end());
  }
  if (!options.surface.empty()) {
    writeMeshFile(options.surface, simulation.surfaceMesh());
    files.push_back(options.surface);
  }
  if (!options.pieces.empty()) {
    const auto written = writePieces(options, simulation);
    files.insert(files.end(), written.begin(), written.end());
  }
  if (!options.plot.empty()) {
    writeFileAtomically(options.plot,
                        [&](std::ostream& out) { out << toSvg(forcePlot(summary, scenario)); });
    files.push_back(options.plot);
  }
  if (!options.json.empty()) writeJson(options.json, toJson(summary, scenario));
  if (!isStandardOutput(options.json)) {
    if (!options.json.empty()) files.push_back(options.json);
    fmt::print(text, "{}", toText(summary, scenario, files));
  }
  if (recorder && !recorder->failure().empty())
    throw error("{}; the operation was run, but not recorded to its end", recorder->failure());
  if (const auto found = findings(summary, scenario); options.strict && !found.empty())
    throw error("{}; leave out --strict to take the run as it is", found.front());
}

}  // namespace

void addRunCommand(Command app) {
  auto options = std::make_shared<RunOptions>();
  Command command = app.subcommand("run", "Run an operation headless and sum it up");
  command.option("SCENARIO", options->scenario,
                 "Scenario file, or the name of one that comes with Resect");
  command.flag("--list", options->list, "List the scenarios that come with Resect");
  command.flag("--thesis", options->thesis,
               "As the original system: tissue is still, instruments take out what they touch");
  command.option(
      "--organ", options->organ,
      "Another organ: model or file of particles, or a built-in one: " + builtInOrgans());
  command.option("--without", options->without,
                 "Instruments of the scenario that stay on the tray, to see what they do");
  command.flag(
      "--strict", options->strict,
      "Exit status 1 if an instrument met no organ, or the run is not as the scenario is meant");
  auto organ = addOrganOptions(command);
  addBreathingOption(command, options->breathing);
  addThreadsOption(command, options->threads);
  addPictureOptions(command, options->pictures);
  command.option("--surface", options->surface,
                 "Mesh file for the surface at the end: .obj .stl .ply .vtk .iv");
  command.option("--pieces", options->pieces,
                 "Folder for a mesh of each separate piece at the end (.stl)");
  addOverwriteOption(
      command, options->overwrite,
      "the numbered files of an earlier run from the folders of --frames and --pieces");
  command.option("--plot", options->plot,
                 "Plot of the force on each instrument over time, where tissue moves (.svg)");
  command.option("--record", options->record,
                 "Recording of the operation (.resect), for replay and verify");
  command.option("--json", options->json, "JSON file for the summary; - for standard output");
  command.footer(
      "Examples:\n"
      "  resect run --list\n"
      "  resect run resect-segment --frames pictures --pieces pieces\n"
      "  resect run cut --organ my_liver.stl --unit mm --spacing 4mm --json cut.json\n"
      "  resect run lift --plot lift.svg\n"
      "  resect run press --record press.resect\n"
      "  resect run perforate --video perforate.mp4 --picture-rate 30");
  command.action([options, organ] { run(*options, *organ); });
}

}  // namespace resect
