// resect organ: scans or several models in, cells with their labels and vessels out.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include <resect/version.h>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "formats/beside_files.h"
#include "formats/labels/brought_organ.h"
#include "formats/particle_info.h"
#include "io/cells/cells_file.h"
#include "io/operation_setup.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"
#include "io/scenario/scenario_files.h"
#include "io/structures.h"

namespace resect {
namespace {

struct OrganCommandOptions {
  std::vector<std::string> files;
  std::string output;
  bool json = false;
};

void makeOrganFile(const OrganCommandOptions& options, const OrganOptions& organ) {
  if (!isCellsFile(options.output))
    throw usageError("--output is {}; give a name that ends in .resect-cells", options.output);
  OrganSource source;
  source.spacing = 0.005;
  source.onTable = false;  // where the files put it
  source.part = organ.part;
  source.file = options.files[0];
  OrganOptions others = organ;
  if (options.files.size() > 1) {
    if (!organ.unit.empty()) source.unit = parseUnit(organ.unit, "--unit");
    takeFiles(source, options.files);
    others.part.clear();
    if (isLabelled(source.file)) others.unit.clear();  // it is that of the models
  }
  others.applyTo(source);
  std::vector<std::filesystem::path> inputs = shippedFiles();
  inputs.emplace_back(source.file);
  for (const BroughtStructure& one : source.structures) inputs.emplace_back(one.file);
  addFilesBeside(inputs);
  checkOutputs({{{"--output", options.output}, {"--json", options.json ? "-" : ""}}}, inputs);

  std::vector<std::string> notes;
  std::optional<Pose> place;
  KeptCells kept;
  TriangleMesh surface;
  kept.cells = loadCells(source, modelReader(), progressBar("particles"), &notes, &place, &surface);
  if (const auto vessels = vesselsOf(source, place, surface, modelReader(), &notes))
    kept.vessels = vessels->anatomy;
  kept.origin = {"resect " RESECT_VERSION, std::filesystem::path(source.file).filename().string(),
                 source.unit, inputsOf(source)};
  writeCells(options.output, kept);
  if (options.json) {
    auto json = toJson(kept, options.output);
    json["notes"] = notes;
    writeJson("-", json);
    return;
  }
  std::FILE* text = placeForText({options.output});
  printNotes(text, notes);
  fmt::print(text, "{}", toText(kept, options.output));
}

}  // namespace

void addOrganCommand(Command app) {
  auto options = std::make_shared<OrganCommandOptions>();
  Command command =
      app.subcommand("organ", "Make a file of cells from what a scan or several models hold");
  command
      .option("FILE", options->files,
              "A label image (.nii .nrrd .mha .dcm), a folder of them, or files of one structure "
              "each: images or models")
      .required();
  command.option("-o,--output", options->output, "File to write: .resect-cells").required();
  command.flag("--json", options->json, "Print JSON");
  auto organ = addOrganOptions(command);
  command.footer(
      "The file holds cells, labels, vessels and where they come from; use it as --organ of run, "
      "window and others.\n"
      "Examples:\n"
      "  resect organ segmentations/ -o patient.resect-cells\n"
      "  resect organ labels.nii.gz --label liver -o liver.resect-cells\n"
      "  resect organ liver.stl tumour.stl portal_vein.stl --unit mm -o case.resect-cells\n"
      "  resect organ labels.nii.gz --label 1 --structure tumour=2 -o case.resect-cells");
  command.action([options, organ] { makeOrganFile(*options, *organ); });
}

}  // namespace resect
