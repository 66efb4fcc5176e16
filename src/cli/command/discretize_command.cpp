// resect discretize: mesh in, particles out, in the thesis's text format or with labels and origin.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <resect/version.h>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "formats/beside_files.h"
#include "io/cells/particle_file.h"
#include "io/operation_setup.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/scenario_files.h"

namespace resect {

void addDiscretizeCommand(Command app) {
  struct DiscretizeOptions {
    std::string mesh, output;
    bool json = false;
  };
  auto options = std::make_shared<DiscretizeOptions>();
  Command command = app.subcommand("discretize", "Turn a closed mesh into particles on a lattice");
  command
      .option("MESH", options->mesh,
              "Model file, a built-in organ (" + builtInOrgans() +
                  "), or a scenario (.toml) for its organ")
      .required();
  command
      .option("-o,--output", options->output,
              "File of particles to write: .resect-cells, or .dis without labels")
      .required();
  command.flag("--json", options->json, "Print JSON");
  auto organ = addOrganOptions(command);
  command.footer(
      "Without --spacing and --dims: cubic cells of 5mm.\n"
      "Examples:\n  resect discretize liver.iv --spacing 5mm -o liver.dis\n  resect discretize "
      "liver.iv --dims 20 -o liver20.dis\n  resect discretize my_operation.toml -o "
      "labelled.resect-cells");
  command.action([options, organ] {
    OrganSource source;
    std::vector<std::string> notes;
    std::vector<std::filesystem::path> inputs{options->mesh};
    if (std::filesystem::path(options->mesh).extension() == ".toml") {
      const Scenario scenario = readScenario(options->mesh);
      if (scenario.organs.size() > 1)
        notes.push_back(fmt::format("of {} organs only the first, \"{}\", is written",
                                    scenario.organs.size(), scenario.organs[0].source.name));
      source = scenario.organs[0].source;  // at its position there, with its labels
      inputs = filesRead(scenario);
    } else {
      source.file = options->mesh;
      source.onTable = false;
      source.spacing = 0.005;
    }
    organ->applyTo(source);
    addFilesBeside(inputs);
    checkOutputs({{{"--output", options->output}, {"--json", options->json ? "-" : ""}}}, inputs);
    const Discretization cells = loadCells(source, modelReader(), progressBar("particles"), &notes);
    writeParticleFile(options->output,
                      {cells,
                       {"resect " RESECT_VERSION,
                        std::filesystem::path(source.file).filename().string(), source.unit}});
    if (!isCellsFile(options->output) && !cells.label.empty())
      notes.push_back("a .dis file has no labels; write a .resect-cells file to keep them");
    const Lattice& lattice = cells.lattice;
    if (options->json) {
      nlohmann::ordered_json json;
      json["particles"] = cells.particleCount();
      if (lattice.cubic())
        json["spacing_m"] = lattice.spacing.x();
      else
        json["spacing_m"] = {lattice.spacing.x(), lattice.spacing.y(), lattice.spacing.z()};
      json["volume_ml"] = 1e6 * cells.volume();
      json["dims"] = {lattice.dims.x(), lattice.dims.y(), lattice.dims.z()};
      json["notes"] = notes;
      json["file"] = options->output;
      writeJson("-", json);
      return;
    }
    std::FILE* text = placeForText({options->output});
    printNotes(text, notes);
    printLine(text, "{}: {} particles, spacing {}{}, {:.1f} ml", options->output,
              cells.particleCount(), lengthText(lattice.spacing.x()),
              lattice.cubic() ? ""
                              : fmt::format(" x {} x {}", lengthText(lattice.spacing.y()),
                                            lengthText(lattice.spacing.z())),
              1e6 * cells.volume());
    if (!lattice.cubic())
      fmt::print(
          text,
          "note: cells are not cubes; such an organ can be shown and carved but not deform: use "
          "--spacing for one that can\n");
  });
}

}  // namespace resect
