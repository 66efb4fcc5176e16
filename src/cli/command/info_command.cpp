#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "formats/beside_files.h"
#include "formats/labels/brought_organ.h"
#include "formats/labels/image_report.h"
#include "formats/labels/label_slices.h"
#include "formats/model_info.h"
#include "formats/particle_info.h"
#include "inventor/reading/model_file.h"
#include "io/cells/particle_file.h"
#include "io/organ_mesh.h"
#include "io/output/run_files.h"
#include "io/scenario/length.h"

namespace resect {
namespace {

struct InfoOptions {
  std::string file, part, unit = "m", slices;
  bool json = false;
};

void infoOfParticles(const InfoOptions& options) {
  if (!options.part.empty())
    throw usageError("{} holds particles: it has no parts; leave --part out", options.file);
  const KeptCells kept = readParticleFile(options.file, parseUnit(options.unit, "--unit"));
  if (options.json)
    writeJson("-", toJson(kept, options.file));
  else
    fmt::print("{}", toText(kept, options.file));
}

// Three slices of the organ's image, and of those of what lies in it.
void writeSlices(const OrganSource& source, const std::string& file) {
  constexpr int kHeight = 256;                             // pixels
  if (std::filesystem::is_directory(source.file)) return;  // no organ was found in it
  std::vector<std::string> files{source.file};
  for (const BroughtStructure& one : source.structures)
    if (isImageFile(one.file) && std::ranges::find(files, one.file) == files.end())
      files.push_back(one.file);
  const RgbImage slices = readLabelSlices(files, kHeight);
  if (slices.height > 0) writePng(file, slices);
}

// The label images of a folder, with what their names tell.
nlohmann::ordered_json filesOf(const std::string& folder) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  std::vector<std::string> notes;  // which takeLabels() gives too
  for (const FolderImage& one : imagesOf(folder, notes))
    files.push_back({{"file", one.file},
                     {"name", one.name},
                     {"kind", one.kind ? nlohmann::ordered_json(wordOf(*one.kind)) : nullptr}});
  return files;
}

// About the image, or the folder of images, and about the organ that it would give.
void infoOfLabels(const InfoOptions& options) {
  if (options.unit != "m")
    throw usageError("{}: label images tell their size themselves; leave --unit out", options.file);
  LabelFacts facts;
  const bool folder = std::filesystem::is_directory(options.file);
  if (folder)
    facts.description = "folder";
  else
    facts = readLabelFacts(options.file, progressBar("reading"));
  nlohmann::ordered_json json = toJson(facts, options.file);
  if (folder) json["files"] = filesOf(options.file);
  std::string text = toText(facts, options.file);
  OrganSource source;
  source.file = options.file;
  source.part = options.part;
  try {
    takeLabels(source);
    const Model model = readModelWatched(source.file, progressBar("reading"), source.part);
    ModelInfo organ = modelInfo(model, {source.part, false, 1});
    organ.notes.insert(organ.notes.begin(), source.notes.begin(), source.notes.end());
    const nlohmann::ordered_json more = toJson(organ);
    for (const auto& [key, value] : more.items())
      if (!json.contains(key)) json[key] = value;
    const std::string about = toText(organ);
    text += "organ\n" + about.substr(about.find('\n') + 1);
  } catch (const Error& e) {
    json["refusal"] = e.what();
    std::string_view why = e.what();
    if (why.starts_with(options.file + ": ")) why.remove_prefix(options.file.size() + 2);
    text += fmt::format("  as an organ: refused: {}\n", shownSentence(why));
  }
  if (!options.slices.empty()) writeSlices(source, options.slices);
  if (options.json)
    writeJson("-", json);
  else
    fmt::print("{}", text);
}

void info(const InfoOptions& options) {
  if (!options.slices.empty()) {
    if (!isLabelled(options.file))
      throw usageError("{}: is no label image; leave --slices out", options.file);
    checkPngFile(options.slices);
    std::vector<std::filesystem::path> inputs{options.file};
    addFilesBeside(inputs);
    checkOutputs({{{"--slices", options.slices}, {"--json", options.json ? "-" : ""}}}, inputs);
  }
  if (isParticleFile(options.file)) return infoOfParticles(options);
  if (isLabelled(options.file)) return infoOfLabels(options);
  const double metres = parseUnit(options.unit, "--unit");
  const Model model = readModelWatched(options.file, progressBar("reading"), options.part);
  const ModelInfo result = modelInfo(model, {options.part, false, metres});
  if (options.json)
    writeJson("-", toJson(result));
  else
    fmt::print("{}", toText(result));
}

}  // namespace

void addInfoCommand(Command app) {
  auto options = std::make_shared<InfoOptions>();
  Command command = app.subcommand("info", "Tell what a file holds and whether it is sound");
  command
      .option(
          "FILE", options->file,
          ".iv .wrl .obj .stl .ply .off .glb .gltf .3mf .vtk; label images: .nii .nrrd .mha .dcm; "
          "particles: .dis .resect-cells")
      .required();
  addPartOption(command, options->part);
  command
      .option("--unit", options->unit,
              "What the file's numbers are: mm, cm, m, inch or the metres in one unit")
      .showDefault();
  command.option("--slices", options->slices,
                 "Picture to write of a label image: three slices (.png)");
  command.flag("--json", options->json, "Print JSON");
  command.footer(
      "Examples:\n"
      "  resect info liver.iv\n"
      "  resect info scan.stl --unit mm\n"
      "  resect info liver.glb --part gallbladder --json\n"
      "  resect info labels.nii.gz\n"
      "  resect info organ.obj --part capsule --part bare_area");
  command.action([options] { info(*options); });
}

}  // namespace resect
