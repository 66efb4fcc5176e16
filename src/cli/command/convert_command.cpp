#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "formats/beside_files.h"
#include "geometry/measures.h"
#include "inventor/reading/model_file.h"
#include "io/mesh_file.h"
#include "io/organ_mesh.h"
#include "io/organ_size.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"

namespace resect {
namespace {

struct ConvertOptions {
  std::string in, out, part, unit = "m";
  bool repair = false, json = false;
};

void convert(const ConvertOptions& options) {
  // Wrong names and units are reported before the work.
  checkWritableMeshFile(options.out);
  std::vector<std::filesystem::path> inputs{options.in};
  addFilesBeside(inputs);
  checkOutputs({{{"OUT", options.out}, {"--json", options.json ? "-" : ""}}}, inputs);
  const double metres = parseUnit(options.unit, "--unit");
  const Model model = readModelWatched(options.in, progressBar("reading"), options.part);
  TriangleMesh mesh;
  std::vector<std::string> notes;
  int holes = 0;
  if (options.repair) {
    OrganMesh organ = prepareOrganMesh(model, {options.part, true, metres});
    mesh = std::move(organ.mesh);
    notes = std::move(organ.notes);
    holes = organ.repairs.holesClosed;
  } else {
    mesh = weldSurface(chosenSurface(model, options.part, metres)).mesh;
    if (mesh.triangles.empty())
      throw error("{}: all its triangles are degenerate; export the model again", model.path);
    const std::string doubt = sizeDoubt(bounds(mesh), metres);
    if (!doubt.empty()) notes.push_back(doubt);
  }
  writeMeshFile(options.out, mesh);
  if (options.json) {
    writeJson("-", {{"written", options.out},
                    {"triangles", mesh.triangles.size()},
                    {"vertices", mesh.points.size()},
                    {"volume_ml", volume(mesh) * 1e6},
                    {"holes_closed", holes},
                    {"notes", notes}});
    return;
  }
  std::FILE* text = placeForText({options.out});
  for (const std::string& note : notes) printLine(text, "{}: {}", options.in, shownSentence(note));
  printLine(text, "{}: {} triangles, {} vertices, {:.6g} ml", options.out, mesh.triangles.size(),
            mesh.points.size(), volume(mesh) * 1e6);
}

}  // namespace

void addConvertCommand(Command app) {
  auto options = std::make_shared<ConvertOptions>();
  Command command = app.subcommand("convert", "Write a model in another format, in metres");
  command.option("IN", options->in, ".iv .wrl .obj .stl .ply .off .glb .gltf .3mf .vtk").required();
  command.option("OUT", options->out, ".obj .stl .ply .vtk .iv").required();
  addPartOption(command, options->part);
  command
      .option("--unit", options->unit,
              "What IN's numbers are: mm, cm, m, inch or the metres in one unit")
      .showDefault();
  command.flag("--repair", options->repair,
               "Make a closed body: close holes, turn what is inside out, drop specks");
  command.flag("--json", options->json, "Print JSON");
  command.footer(
      "Examples:\n"
      "  resect convert liver.iv liver.stl\n"
      "  resect convert scan.stl liver.obj --unit mm --repair\n"
      "  resect convert liver.glb gallbladder.iv --part gallbladder\n"
      "  resect convert organ.obj organ.stl --part capsule --part bare_area");
  command.action([options] { convert(*options); });
}

}  // namespace resect
