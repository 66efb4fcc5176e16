// resect surface: particles in, iso-surface of their colour field out.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/process/standard_streams.h"
#include "io/cells/particle_file.h"
#include "io/mesh_file.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"
#include "operation/run.h"
#include "organ/organ.h"

namespace resect {

void addSurfaceCommand(Command app) {
  struct SurfaceOptions {
    std::string input, output, unit = "m";
    float iso = 50;
    int refine = 2;
    bool json = false;
  };
  auto options = std::make_shared<SurfaceOptions>();
  Command command =
      app.subcommand("surface", "Write the surface of the organ in a file of particles");
  command.option("FILE", options->input, "File of particles: .dis .resect-cells").required();
  command.option("-o,--output", options->output, "Mesh file: .obj .stl .ply .vtk .iv").required();
  command.option("--iso", options->iso, "Iso level of the colour field, 1 to 98").showDefault();
  command.option("--refine", options->refine, "Surface nodes per cell, 1 to 4").showDefault();
  command
      .option("--unit", options->unit,
              "What the file's numbers are: mm, cm, m, um, in, or metres per unit")
      .showDefault();
  command.flag("--json", options->json, "Print JSON");
  command.footer("Example:\n  resect surface liver.dis --iso 50 --refine 2 -o surface.obj");
  command.action([options] {
    checkWritableMeshFile(options->output);
    const std::filesystem::path input = options->input;
    checkOutputs({{{"--output", options->output}, {"--json", options->json ? "-" : ""}}},
                 {&input, 1});
    Discretization cells =
        readParticleFile(options->input, parseUnit(options->unit, "--unit")).cells;
    const Organ organ = makeOrgan(std::move(cells), {options->refine, options->iso});
    const TriangleMesh mesh = organ.surface.mesh();
    if (mesh.triangles.empty())
      throw error("{} has no surface at iso level {}; use a lower --iso", options->input,
                  options->iso);
    writeMeshFile(options->output, mesh);
    const SurfaceSummary summary = summarise(mesh);
    if (options->json) {
      writeJson("-", {{"particles", organ.particles},
                      {"triangles", summary.triangles},
                      {"closed", summary.closed},
                      {"oriented", summary.oriented},
                      {"volume_ml", 1e6 * summary.volume},
                      {"file", options->output}});
      return;
    }
    printLine(placeForText({options->output}), "{}: {} triangles from {} particles, {}, {:.1f} ml",
              options->output, summary.triangles, organ.particles,
              summary.closed ? "closed" : "open", 1e6 * summary.volume);
  });
}

}  // namespace resect
