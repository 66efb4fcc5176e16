#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "formats/model_info.h"
#include "formats/particle_info.h"
#include "inventor/reading/model_file.h"
#include "io/cells/particle_file.h"
#include "io/organ_mesh.h"
#include "io/scenario/length.h"

namespace resect {
namespace {

struct Options {
  std::string file, part, unit = "m";
  bool json = false;
};

void infoOfParticles(const Options& options) {
  if (!options.part.empty())
    throw usageError("{} holds particles: it has no parts; leave --part out", options.file);
  const KeptCells kept = readParticleFile(options.file, parseUnit(options.unit, "--unit"));
  if (options.json)
    writeJson("-", toJson(kept, options.file));
  else
    fmt::print("{}", toText(kept, options.file));
}

void info(const Options& options) {
  if (isParticleFile(options.file)) return infoOfParticles(options);
  const double metres = parseUnit(options.unit, "--unit");
  const Model model = readModelWatched(options.file, progressBar("reading"));
  const ModelInfo result = modelInfo(model, {options.part, false, metres});
  if (options.json)
    writeJson("-", toJson(result));
  else
    fmt::print("{}", toText(result));
}

}  // namespace

void addInfoCommand(Command app) {
  auto options = std::make_shared<Options>();
  Command command = app.subcommand("info", "Tell what a file holds and whether it is sound");
  command
      .option("FILE", options->file,
              ".iv .wrl .obj .stl .ply .off .glb .gltf .vtk; particles: .dis .resect-cells")
      .required();
  addPartOption(command, options->part);
  command
      .option("--unit", options->unit,
              "What the file's numbers are: mm, cm, m, inch or the metres in one unit")
      .showDefault();
  command.flag("--json", options->json, "Print JSON");
  command.footer(
      "Examples:\n"
      "  resect info liver.iv\n"
      "  resect info scan.stl --unit mm\n"
      "  resect info liver.glb --part gallbladder --json\n"
      "  resect info organ.obj --part capsule --part bare_area");
  command.action([options] { info(*options); });
}

}  // namespace resect
