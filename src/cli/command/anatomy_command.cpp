// resect anatomy: the vessels of the built-in liver, or vessels grown into another organ: measures,
// meshes, a file.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/measure_anatomy.h"
#include "anatomy/vessel_mesh.h"
#include "base/error.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/process/standard_streams.h"
#include "io/data_folder.h"
#include "io/mesh_file.h"
#include "io/organ_mesh.h"
#include "io/output/run_files.h"
#include "io/plain_mesh.h"
#include "io/scenario/length.h"
#include "io/vessels_file.h"
#include "organ/builtin/builtin_liver.h"

namespace resect {
namespace {

struct Options {
  std::string organ, unit = "m", out, meshes;
  std::vector<double> hilum, cava;
  int terminals = 1000, seed = 1;
  bool json = false;
};

constexpr double kOut = 0.02;  // m: how far outside the organ its large vessels begin

// A place outside the organ, straight out from one near its surface.
Vec3 outside(const TriangleMesh& organ, const Vec3& place) {
  const SignedDistance distance(organ, 2 * kOut, 0.0025);
  Vec3 p = place;
  for (int i = 0; i < 100 && distance(p).distance < kOut; ++i) {
    const Vec3 out = distance(p).outwards;
    if (out.isZero()) break;
    p += 0.1 * kOut * out;
  }
  return p;
}

Vec3 placeFrom(const std::vector<double>& numbers, const char* option, double metres) {
  if (numbers.size() != 3)
    throw usageError("{} needs three numbers, x y z in the file's unit, where the vessels enter",
                     option);
  return metres * Vec3(numbers[0], numbers[1], numbers[2]);
}

struct Grown {
  TriangleMesh organ;
  Anatomy anatomy;
};

Grown anatomyOf(const Options& options) {
  if (options.organ.empty()) {
    const std::filesystem::path folder = dataFolder() / "organs";
    return {merged(readPlainMesh(folder / "liver.ply")), readVessels(folder / "liver.vessels")};
  }
  VesselGrowth growth;
  const double metres = parseUnit(options.unit, "--unit");
  growth.hilum = placeFrom(options.hilum, "--hilum", metres);
  growth.cava = placeFrom(options.cava, "--cava", metres);
  growth.terminals = options.terminals;
  growth.seed = std::uint64_t(options.seed);
  TriangleMesh organ = prepareOrganMesh(modelReader()(options.organ), {"", false, metres}).mesh;
  growth.hilumOut = outside(organ, growth.hilum);
  growth.cavaOut = outside(organ, growth.cava);
  Anatomy anatomy = growVessels(organ, growth);
  return {std::move(organ), std::move(anatomy)};
}

nlohmann::ordered_json toJson(const AnatomyMeasures& measures) {
  nlohmann::ordered_json json;
  for (int k = 0; k < kVesselKinds; ++k) {
    const VesselMeasures& m = measures.kinds[std::size_t(k)];
    auto& kind = json["vessels"][std::string(wordOf(VesselKind(k)))];
    kind = {
        {"segments", m.segments},        {"terminals", m.terminals},
        {"lumen_ml", 1e6 * m.volume},    {"length_m", m.length},
        {"outside_mm", 1e3 * m.outside}, {"radius_mm_by_order", nlohmann::ordered_json::array()}};
    for (const double r : m.radiusByOrder) kind["radius_mm_by_order"].push_back(1e3 * r);
    for (int other = 0; other < k; ++other) {
      const std::string pair =
          fmt::format("{} and {}", wordOf(VesselKind(other)), wordOf(VesselKind(k)));
      json["crossings"][pair] = measures.crossings[std::size_t(k)][std::size_t(other)];
      json["gap_mm"][pair] = 1e3 * measures.gaps[std::size_t(k)][std::size_t(other)];
    }
  }
  return json;
}

void anatomy(const Options& options) {
  checkOutputs({{{"--output", options.out}, {"--json", options.json ? "-" : ""}}});
  const Grown grown = anatomyOf(options);
  if (!options.out.empty()) writeVessels(options.out, grown.anatomy);
  std::vector<std::string> written;
  for (int k = 0; k < kVesselKinds && !options.meshes.empty(); ++k) {
    const auto file =
        std::filesystem::path(options.meshes) / fmt::format("{}.ply", wordOf(VesselKind(k)));
    writeMeshFile(file, vesselMesh(grown.anatomy, VesselKind(k)));
    written.push_back(file.string());
  }
  const AnatomyMeasures measures = measure(grown.anatomy, grown.organ);
  if (options.json) return writeJson("-", toJson(measures));
  std::FILE* text = placeForText({options.out});
  int crossings = 0;
  for (int k = 0; k < kVesselKinds; ++k) {
    const VesselMeasures& m = measures.kinds[std::size_t(k)];
    if (m.segments == 0) continue;
    printLine(text, "{:<15} {:5} segments, {:4} terminals, {:5.1f} ml, radius {:.2f} to {:.2f} mm",
              nameOf(VesselKind(k)), m.segments, m.terminals, 1e6 * m.volume,
              1e3 * m.radiusByOrder.front(), 1e3 * m.radiusByOrder.back());
    for (int other = 0; other < k; ++other)
      crossings += measures.crossings[std::size_t(k)][std::size_t(other)];
  }
  printLine(text, "{} pairs of vessels of two kinds cross", crossings);
  for (const std::string& file : written) printLine(text, "{}", file);
}

}  // namespace

void addAnatomyCommand(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("anatomy", "Show the liver's vessels, or grow vessels into an organ");
  command->add_option("--organ", options->organ,
                      "Model file of a closed organ to grow vessels into");
  command->add_option("--unit", options->unit, "Unit of that file: mm, cm, m, in")
      ->capture_default_str();
  command->add_option("--hilum", options->hilum, "Where portal vein, artery and duct enter: x y z")
      ->expected(3);
  command->add_option("--cava", options->cava, "Where the hepatic veins leave: x y z")->expected(3);
  command->add_option("--terminals", options->terminals, "Ends of each tree, 30 to 5000")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Another seed gives other vessels")
      ->capture_default_str();
  command->add_option("-o,--output", options->out, "File to write the vessels to (.vessels)");
  command->add_option("--meshes", options->meshes,
                      "Folder for a mesh of each kind of vessel (.ply)");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Examples:\n  resect anatomy --meshes trees && resect render trees/*.ply -o trees.png\n"
      "  resect anatomy --organ my_liver.stl --unit mm --hilum 35 -20 10 --cava 35 42 -16 -o "
      "my.vessels");
  command->callback([options] { anatomy(*options); });
}

}  // namespace resect
