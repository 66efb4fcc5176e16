// resect render: models as a picture.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>

#include "anatomy/liver_segments.h"
#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/picture_writer.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "formats/beside_files.h"
#include "formats/png_file.h"
#include "geometry/resting_pose.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operating_room.h"
#include "inventor/scene/operation_view.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/organ_mesh.h"
#include "io/organ_size.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"
#include "io/scenario/scenario_files.h"
#include "operation/room.h"

namespace resect {
namespace {

struct RenderOptions {
  std::vector<std::string> models;
  std::string out, size = "1280x720", view = "surgeon", quality = "window", part, unit = "m",
                   pose = "lie";
  bool noRoom = false, json = false;
};

// Screen colour of a tissue, by anatomical words in its file's name.
Vec3f tissueColour(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  if (has("gall") || has("bile") || has("duct")) return {0.34f, 0.40f, 0.17f};
  if (has("arter") || has("aorta")) return {0.62f, 0.13f, 0.10f};
  if (has("portal")) return {0.36f, 0.24f, 0.44f};
  if (has("vein") || has("cava") || has("venous")) return {0.24f, 0.25f, 0.45f};
  if (has("tumour") || has("tumor") || has("lesion")) return {0.78f, 0.66f, 0.50f};
  // Colours that people with any colour vision tell apart (Okabe and Ito 2008).
  constexpr float kSegments[kLiverSegments][3] = {
      {0.35f, 0.35f, 0.35f}, {0.80f, 0.40f, 0.00f}, {0.90f, 0.62f, 0.00f}, {0.90f, 0.85f, 0.30f},
      {0.00f, 0.60f, 0.45f}, {0.34f, 0.70f, 0.90f}, {0.00f, 0.45f, 0.70f}, {0.75f, 0.45f, 0.62f}};
  for (int k = 0; k < kLiverSegments; ++k)
    if (std::filesystem::path(file).stem().string() ==
        fmt::format("segment-{}", romanNumber(k + 1)))
      return Vec3f(kSegments[k]);
  return kLiverColour;
}

Eigen::Quaterniond rotationFor(const std::string& pose, const TriangleMesh& mesh) {
  return pose == "lie" ? restingRotation(mesh) : Eigen::Quaterniond::Identity();
}

void render(const RenderOptions& options) {
  int width = 0, height = 0;
  parseSize(options.size, width, height);
  const auto view = roomView(options.view);
  if (!view) throw usageError("--view is \"{}\"; choose {}", options.view, kRoomViewNames);
  const double metres = parseUnit(options.unit, "--unit");
  checkPngFile(options.out);
  std::vector<std::filesystem::path> inputs = shippedFiles();
  inputs.insert(inputs.end(), options.models.begin(), options.models.end());
  addFilesBeside(inputs);
  checkOutputs({{{"--output", options.out}, {"--json", options.json ? "-" : ""}}}, inputs);
  const PictureQuality quality = requireQuality(options.quality);
  // Before reading, so that a missing EGL is reported first.
  OffscreenView picture(width, height, quality);

  std::vector<TriangleMesh> meshes;
  TriangleMesh all;
  for (const std::string& file : options.models) {
    const Model model = readModelWatched(file, progressBar("reading"), options.part);
    meshes.push_back(weldSurface(chosenSurface(model, options.part, metres)).mesh);
    if (meshes.back().triangles.empty())
      throw error("{}: all its triangles are degenerate; export the model again", file);
    append(all, meshes.back());
  }
  // Lamps and patterns are made for organs: other sizes are scaled to one.
  const double extent = bounds(all).size().maxCoeff();
  const double scale = extent < 0.01 || extent > 1.0 ? 0.2 / extent : 1.0;
  if (scale != 1.0)
    fmt::print(stderr, "the models are shown as if 0.2 m across: {}\n",
               shownSentence(sizeDoubt(bounds(all), metres)));
  for (Vec3& p : all.points) p *= scale;
  Pose pose;
  if (options.pose != "keep") pose = standOnTable(all, rotationFor(options.pose, all));

  OperatingRoom room;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (Vec3& p : meshes[i].points) p = pose * (scale * p);
    if (i == 0)
      room.setOrgan(meshes[i], tissueColour(options.models[i]));
    else
      room.addTissue(meshes[i], tissueColour(options.models[i]));
  }
  if (!options.noRoom) {
    room.setTable(readRoomModel("table"));
    const std::array tools = {"scalpel", "hook", "baton"};
    room.setToolbox(toolPlaces(tools.size()));
    int place = 0;
    for (const char* tool : tools)
      room.setToolPose(room.addTool(loadTool(tool, &readModel)), toolBoxPlace(place++));
  }
  const std::size_t triangles = all.triangles.size();
  const Aabb box = bounds(transformed(std::move(all), pose));
  room.setShadowResolution(quality.shadowTexels);
  room.lightUp(box);
  room.look(*view, box, double(width) / height);
  writePng(options.out, picture.render(room.root()));
  if (options.json) {
    writeJson("-", {{"file", options.out},
                    {"width", width},
                    {"height", height},
                    {"triangles", triangles},
                    {"renderer", picture.renderer()}});
    return;
  }
  printLine(placeForText({options.out}), "{}: {} x {} pixels, drawn by {}", options.out, width,
            height, picture.renderer());
}

}  // namespace

void addRenderCommand(Command app) {
  auto options = std::make_shared<RenderOptions>();
  Command command = app.subcommand("render", "A picture of models in the operating room");
  command
      .option("MESH", options->models,
              "Models of one coordinate system; vessels, gallbladders and segments are coloured by "
              "their files' names")
      .required();
  command.option("-o,--output", options->out, "Picture to write (.png)").required();
  command.option("--size", options->size, "Width and height of the picture, pixels").showDefault();
  addQualityOption(command, options->quality);
  command.option("--view", options->view, fmt::format("Camera: {}", kRoomViewNames)).showDefault();
  command
      .option("--pose", options->pose,
              "lie: as the body would come to rest on the table; stand: as in the file, on the "
              "table; keep: where the file has it")
      .oneOf({"lie", "stand", "keep"})
      .showDefault();
  command.flag("--no-room,!--room", options->noRoom, "Without table, tool box and tools");
  addPartOption(command, options->part);
  command
      .option("--unit", options->unit,
              "What the models' numbers are: mm, cm, m, inch or the metres in one unit")
      .showDefault();
  command.flag("--json", options->json, "Print JSON");
  command.footer(
      "Examples:\n"
      "  resect render liver.iv -o liver.png\n"
      "  resect render liver.obj gallbladder.obj portal_vein.obj -o anatomy.png --no-room\n"
      "  resect render scan.stl --unit mm --view top --size 1920x1080 -o scan.png");
  command.action([options] { render(*options); });
}

}  // namespace resect
