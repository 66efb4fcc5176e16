// resect bench: speed of an operation on this machine, and the largest organ in real time.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "cli/bench_report.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/haptics_report.h"
#include "cli/organ_options.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "cli/thesis_profile.h"
#include "formats/beside_files.h"
#include "io/cells/particle_file.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/scenario_files.h"

namespace resect {
namespace {

struct BenchOptions {
  std::string scenario = "cut", organ, json;
  int threads = 0;
  double most = 1e6;
  bool once = false, thesis = false, profile = false;
  // Of --haptics.
  bool haptics = false;
  double seconds = 60;
  std::string device = "simulated_hand", deviceOptions, tool;
};

// Without a scenario's name.
constexpr const char* kHapticsScenarios[] = {"press", "incise-under-traction"};

BenchReport measure(Scenario scenario, const std::string& title) {
  Simulation simulation = makeSimulation(scenario, modelReader(), progressBar("particles"));
  simulation.keepLook();  // as in the window
  const Progress progress = progressBar(title);
  const double frames = double(frameCount(scenario));
  return benchScenario(simulation, scenario,
                       [&](const Simulation&, const FrameInput&, const StepReport& step) {
                         report(progress, double(step.frame + 1) / frames);
                         return true;
                       });
}

// One core is left to the loop of 1 kHz.
int threadsBesideLoop(int wanted) {
  return wanted > 0 ? wanted : std::max(1, int(std::thread::hardware_concurrency()) - 1);
}

void runHaptics(const BenchOptions& options, const OrganOptions& organOptions, bool named) {
  const ThreadLimit threads(threadsBesideLoop(options.threads));
  std::vector<Scenario> scenarios;
  std::vector<std::filesystem::path> inputs;
  const auto add = [&](const std::string& name) {
    Scenario& scenario =
        scenarios.emplace_back(readScenario(findDataFile(name, "scenarios", ".toml")));
    organOptions.applyTo(scenario, options.organ);
    for (const std::filesystem::path& file : filesRead(scenario)) inputs.push_back(file);
  };
  if (named) add(options.scenario);
  for (const char* name : kHapticsScenarios)
    if (!named) add(name);
  const std::filesystem::path file = findHapticPlugin(options.device);
  inputs.push_back(file);
  addFilesBeside(inputs);
  checkOutputs({{{"--json", options.json}}}, inputs);

  const HapticPlugin plugin(file);
  const bool prints = !isStandardOutput(options.json);
  nlohmann::ordered_json json;
  json["device"] = plugin.name();
  json["runs"] = nlohmann::ordered_json::array();
  for (Scenario& scenario : scenarios) {
    Simulation simulation = makeSimulation(scenario, modelReader(), progressBar("particles"));
    const Progress progress = progressBar(scenario.name);
    const HapticsReport result = benchHaptics(
        simulation, scenario, plugin, {options.seconds, options.deviceOptions, options.tool},
        [&](double share) { report(progress, share); });
    json["runs"].push_back(toJson(result, scenario));
    if (prints) fmt::print("{}\n", toText(result, scenario));
  }
  if (!options.json.empty()) writeJson(options.json, json);
}

void run(const BenchOptions& options, const OrganOptions& organOptions) {
  const ThreadLimit threads(options.threads);
  Scenario scenario = readScenario(findDataFile(options.scenario, "scenarios", ".toml"));
  organOptions.applyTo(scenario, options.organ);
  if (options.thesis) makeThesis(scenario);
  std::vector<std::filesystem::path> inputs = filesRead(scenario);
  addFilesBeside(inputs);
  checkOutputs({{{"--json", options.json}}}, inputs);

  const BenchReport report = measure(scenario, scenario.name);
  std::optional<RealTimeLimit> limit;
  // A file of particles has a fixed spacing.
  if (!options.once && !options.profile && !isParticleFile(scenario.organs[0].source.file))
    limit = findRealTimeLimit(
        report,
        [&](double spacing) {
          Scenario other = scenario;
          setSpacing(other, report.spacing, spacing);
          return measure(other, fmt::format("{} at {:.3g} mm", scenario.name, 1e3 * spacing));
        },
        4, options.most);
  if (!options.json.empty()) {
    nlohmann::ordered_json json = toJson(report, limit, scenario);
    if (options.profile) json["profile"] = profileJson(report);
    writeJson(options.json, json);
  }
  if (isStandardOutput(options.json)) return;
  fmt::print("{}", toText(report, limit, scenario));
  if (options.profile) fmt::print("{}", profileText(report));
}

}  // namespace

void addBenchCommand(Command app) {
  auto options = std::make_shared<BenchOptions>();
  Command command = app.subcommand(
      "bench", "Say how fast an operation is here, and how large an organ keeps real time");
  const Option scenario = command
                              .option("SCENARIO", options->scenario,
                                      "Scenario file, or the name of one that comes with Resect")
                              .showDefault();
  command.option(
      "--organ", options->organ,
      "Another organ: model or file of particles, or a built-in one: " + builtInOrgans());
  auto organ = addOrganOptions(command);
  addThreadsOption(command, options->threads);
  const Option once = command.flag(
      "--once", options->once, "Measure the scenario as it is; do not look for the largest organ");
  const Option thesis =
      command.flag("--thesis", options->thesis,
                   "As the original system: tissue is still, instruments take out what they touch");
  const Option profile = command.flag(
      "--profile", options->profile,
      "The stages by their time beside the profile in the original thesis (implies --once)");
  const Option most =
      command.option("--most", options->most, "Particles of the largest organ to try")
          .range(100.0, 1e8)
          .showDefault();
  const Option haptics = command.flag(
      "--haptics", options->haptics,
      "The force for a hand at 1 kHz: deadlines, jitter, noise, passivity; without SCENARIO of "
      "press and incise-under-traction");
  for (const Option other : {once, thesis, profile, most}) haptics.excludes(other);
  command.option("--seconds", options->seconds, "With --haptics: how long each run lasts")
      .range(1.0, 3600.0)
      .showDefault()
      .needs(haptics);
  command
      .option("--device", options->device,
              "With --haptics: plug-in of a haptic device, or the name of one that comes with "
              "Resect")
      .showDefault()
      .needs(haptics);
  command.option("--device-options", options->deviceOptions, "Text for the plug-in").needs(haptics);
  command
      .option("--tool", options->tool,
              "With --haptics: the one instrument in a hand; without it each that the "
              "scenario moves")
      .needs(haptics);
  command.option("--json", options->json, "JSON file for the figures; - for standard output");
  command.footer(
      "The largest organ is found by trying: up to four more runs at other spacings.\n\n"
      "Examples:\n"
      "  resect bench\n"
      "  resect bench incise --threads 1\n"
      "  resect bench cut-950 --thesis --profile\n"
      "  resect bench cut --spacing 1.15mm --once --json cut.json\n"
      "  resect bench --haptics\n"
      "  resect bench press --haptics --device ./my_device.so --seconds 20");
  command.action([options, organ, scenario] {
    if (options->haptics)
      runHaptics(*options, *organ, scenario.given());
    else
      run(*options, *organ);
  });
}

}  // namespace resect
