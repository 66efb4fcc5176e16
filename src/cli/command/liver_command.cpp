// resect liver: writes the built-in liver as a mesh.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/process/standard_streams.h"
#include "geometry/measures.h"
#include "io/mesh_file.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"
#include "organ/builtin/builtin_liver.h"

namespace resect {

void addLiverCommand(Command app) {
  struct LiverOptions {
    std::string output, edge = "2.5mm";
    bool json = false;
  };
  auto options = std::make_shared<LiverOptions>();
  Command command = app.subcommand("liver", "Write the built-in human liver as a mesh");
  command.option("-o,--output", options->output, "Mesh file: .obj .stl .ply .vtk .iv").required();
  command.option("--edge", options->edge, "Longest edge of a triangle, 0.5mm to 5mm").showDefault();
  command.flag("--json", options->json, "Print JSON");
  command.footer("Example:\n  resect liver -o liver.obj");
  command.action([options] {
    const double edge = parseLength(options->edge, "--edge");
    if (!(edge >= 0.0005 && edge <= 0.005))
      throw usageError("--edge is {}; give a length from 0.5mm to 5mm", options->edge);
    checkWritableMeshFile(options->output);
    checkOutputs({{{"--output", options->output}, {"--json", options->json ? "-" : ""}}});
    const TriangleMesh mesh = builtinLiver(edge);
    writeMeshFile(options->output, mesh);
    if (options->json) {
      writeJson("-", {{"file", options->output},
                      {"triangles", mesh.triangles.size()},
                      {"vertices", mesh.points.size()},
                      {"volume_ml", 1e6 * volume(mesh)}});
      return;
    }
    printLine(placeForText({options->output}), "{}: {} triangles, {:.1f} ml", options->output,
              mesh.triangles.size(), 1e6 * volume(mesh));
  });
}

}  // namespace resect
