// resect bench: speed of an operation on this machine, and the largest organ in real time.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "cli/bench_report.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "cli/thesis_profile.h"
#include "formats/gltf_files.h"
#include "io/cells/particle_file.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/scenario_files.h"

namespace resect {
namespace {

struct Options {
  std::string scenario = "cut", organ, json;
  int threads = 0;
  double most = 1e6;
  bool once = false, thesis = false, profile = false;
};

BenchReport measure(const Scenario& scenario, const std::string& title) {
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

void run(const Options& options, const OrganOptions& organOptions) {
  const ThreadLimit threads(options.threads);
  Scenario scenario = readScenario(findDataFile(options.scenario, "scenarios", ".toml"));
  organOptions.applyTo(scenario, options.organ);
  if (options.thesis) makeThesis(scenario);
  std::vector<std::filesystem::path> inputs = filesRead(scenario);
  addFilesOfGltf(inputs);
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

void addBenchCommand(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "bench", "Say how fast an operation is here, and how large an organ keeps real time");
  command
      ->add_option("SCENARIO", options->scenario,
                   "Scenario file, or the name of one that comes with Resect")
      ->capture_default_str();
  command->add_option(
      "--organ", options->organ,
      "Another organ: model or file of particles, or a built-in one: " + builtInOrgans());
  auto organ = addOrganOptions(*command);
  addThreadsOption(*command, options->threads);
  command->add_flag("--once", options->once,
                    "Measure the scenario as it is; do not look for the largest organ");
  command->add_flag(
      "--thesis", options->thesis,
      "As the original system: tissue is still, instruments take out what they touch");
  command->add_flag(
      "--profile", options->profile,
      "The stages by their time beside the profile in the original thesis (implies --once)");
  command->add_option("--most", options->most, "Particles of the largest organ to try")
      ->check(CLI::Range(100.0, 1e8))
      ->capture_default_str();
  command->add_option("--json", options->json, "JSON file for the figures; - for standard output");
  command->footer(
      "The largest organ is found by trying: up to four more runs at other spacings.\n\n"
      "Examples:\n"
      "  resect bench\n"
      "  resect bench incise --threads 1\n"
      "  resect bench cut-950 --thesis --profile\n"
      "  resect bench cut --spacing 1.15mm --once --json cut.json");
  command->callback([options, organ] { run(*options, *organ); });
}

}  // namespace resect
