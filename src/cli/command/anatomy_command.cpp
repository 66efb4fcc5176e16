// resect anatomy: the vessels of the built-in liver, or vessels grown into another organ: measures,
// meshes, a file.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/measure_anatomy.h"
#include "anatomy/vessel_mesh.h"
#include "base/error.h"
#include "blood/flow/vessel_flow.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/organ_options.h"
#include "cli/process/standard_streams.h"
#include "io/data_folder.h"
#include "io/mesh_file.h"
#include "io/organ_mesh.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/plain_mesh.h"
#include "io/scenario/length.h"
#include "io/structures.h"
#include "io/vessels_file.h"
#include "organ/builtin/builtin_liver.h"

namespace resect {
namespace {

struct AnatomyOptions {
  std::string organ, unit = "m", out, meshes, json;
  std::vector<std::string> structures;  // KIND=FILE
  std::vector<double> hilum, cava;
  int terminals = 1000, seed = 1;
  bool flows = false, onlyFound = false;
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

// The centre lines of vessels in model files, with smaller vessels.
Anatomy broughtVessels(const AnatomyOptions& options, const TriangleMesh& organ, double metres) {
  OrganSource source;
  source.smallVessels = !options.onlyFound;
  for (const std::string& one : options.structures) {
    const std::size_t sign = one.find('=');
    const std::string word = one.substr(0, sign);
    const auto kind = structureKind(word);
    if (sign == std::string::npos || !kind || wordOf(*kind) != word || !vesselKind(*kind))
      throw usageError(
          "--structure is \"{}\"; give a kind of vessel and its file, such as "
          "portal-vein=portal.obj",
          one);
    source.structures.push_back({*kind, 0, "", one.substr(sign + 1), "", metres});
  }
  return vesselsOf(source, Pose(), organ, modelReader(), nullptr)->anatomy;
}

Grown anatomyOf(const AnatomyOptions& options) {
  if (options.organ.empty()) {
    if (!options.structures.empty())
      throw usageError("--structure needs the organ that the vessels belong to; add --organ FILE");
    const std::filesystem::path folder = dataFolder() / "organs";
    return {merged(readPlainMesh(folder / "liver.ply")), readVessels(folder / "liver.vessels")};
  }
  const double metres = parseUnit(options.unit, "--unit");
  TriangleMesh organ = prepareOrganMesh(modelReader()(options.organ, {}), {"", false, metres}).mesh;
  if (!options.structures.empty()) {
    Anatomy brought = broughtVessels(options, organ, metres);
    return {std::move(organ), std::move(brought)};
  }
  VesselGrowth growth;
  growth.hilum = placeFrom(options.hilum, "--hilum", metres);
  growth.cava = placeFrom(options.cava, "--cava", metres);
  growth.terminals = options.terminals;
  growth.seed = std::uint64_t(options.seed);
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

// Couinaud's segments and the larger vessels by their names.
nlohmann::ordered_json segmentsJson(const Grown& grown, const LiverSegments& segments) {
  constexpr std::int32_t kFewest = 10;  // terminals of a vessel that is listed
  nlohmann::ordered_json json;
  const auto volumes = segmentVolumes(segments, grown.organ);
  for (int k = 0; k < kLiverSegments; ++k)
    json["segments_ml"][std::string(romanNumber(k + 1))] = 1e6 * volumes[std::size_t(k)];
  json["branches"] = nlohmann::ordered_json::array();
  for (const NamedVessel& v : namedVessels(grown.anatomy, segments, kFewest))
    json["branches"].push_back({{"name", v.name},
                                {"kind", wordOf(v.kind)},
                                {"diameter_mm", 2e3 * v.radius},
                                {"terminals", v.terminals}});
  return json;
}

// The organ's surface, parted by segments: the triangles whose middle lies in one.
TriangleMesh surfaceOf(const TriangleMesh& organ, const LiverSegments& segments, int segment) {
  TriangleMesh part;
  std::vector<std::int32_t> number(organ.points.size(), -1);
  for (const auto& triangle : organ.triangles) {
    Vec3 middle = Vec3::Zero();
    for (const auto v : triangle) middle += organ.points[std::size_t(v)].cast<double>() / 3;
    if (segments.at(middle) != segment) continue;
    auto own = triangle;
    for (auto& v : own) {
      std::int32_t& n = number[std::size_t(v)];
      if (n < 0) {
        n = std::int32_t(part.points.size());
        part.points.push_back(organ.points[std::size_t(v)]);
      }
      v = n;
    }
    part.triangles.push_back(own);
  }
  return part;
}

// Steady flow out of both ends of a vessel that is severed in its middle, at the hilum's height,
// ml/s.
double flowOut(const VesselFlow& flow, std::int32_t segment, bool clip, bool clamp) {
  VesselState state;
  VesselInjury injury;
  injury.segment = segment;
  injury.cut = (1u << kFilaments) - 1;
  injury.from = injury.to = 0.5;
  state.injuries.push_back(injury);
  state.inflowClamped = clamp;
  if (clip) state.addClip({segment, 0.25});
  const std::vector<EndOutside> outside(1);
  std::vector<double> sinusoids{Circulation().sinusoids};
  for (int i = 0; i < 30; ++i) flow.solve(state, outside, {}, sinusoids);
  return 1e6 * (state.injuries[0].flow[0] + state.injuries[0].flow[1]);
}

// For vessels of some diameters: what they lose when they are cut. least and most: of all vessels
// with that diameter within a tenth.
nlohmann::ordered_json flows(const Anatomy& anatomy) {
  const VesselFlow flow(makeVesselMap(anatomy), {});
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const VesselKind kind :
       {VesselKind::PortalVein, VesselKind::HepaticArtery, VesselKind::HepaticVein})
    for (const double wanted : {1e-3, 2e-3, 3.2e-3, 4e-3, 8e-3}) {
      const VesselRange range = anatomy.range(kind);
      std::int32_t best = -1;
      double nearest = 0.1 * wanted, least = 1e9, most = 0;
      for (std::int32_t i = range.first; i < range.first + range.count; ++i) {
        const VesselSegment& s = anatomy.segments[std::size_t(i)];
        const double off = std::abs(2 * s.radius - wanted);
        if (s.parent < 0 || off > 0.1 * wanted) continue;
        if (off < nearest) nearest = off, best = i;
        const double open = flowOut(flow, i, false, false);
        least = std::min(least, open), most = std::max(most, open);
      }
      if (best < 0) continue;
      rows.push_back({{"kind", wordOf(kind)},
                      {"diameter_mm", 2e3 * anatomy.segments[std::size_t(best)].radius},
                      {"open_ml_s", flowOut(flow, best, false, false)},
                      {"least_open_ml_s", least},
                      {"most_open_ml_s", most},
                      {"clipped_ml_s", flowOut(flow, best, true, false)},
                      {"clamped_ml_s", flowOut(flow, best, false, true)}});
    }
  return rows;
}

void anatomy(const AnatomyOptions& options) {
  checkOutputs({{{"--output", options.out}, {"--json", options.json}}});
  const Grown grown = anatomyOf(options);
  if (!options.out.empty()) writeVessels(options.out, grown.anatomy);
  std::vector<std::string> written;
  for (int k = 0; k < kVesselKinds && !options.meshes.empty(); ++k) {
    const auto file =
        std::filesystem::path(options.meshes) / fmt::format("{}.ply", wordOf(VesselKind(k)));
    writeMeshFile(file, vesselMesh(grown.anatomy, VesselKind(k)));
    written.push_back(file.string());
  }
  const auto segments = LiverSegments::find(grown.anatomy);
  for (int k = 1; k <= kLiverSegments && segments && !options.meshes.empty(); ++k) {
    const TriangleMesh surface = surfaceOf(grown.organ, *segments, k);
    if (surface.triangles.empty()) continue;
    const auto file =
        std::filesystem::path(options.meshes) / fmt::format("segment-{}.ply", romanNumber(k));
    writeMeshFile(file, surface);
    written.push_back(file.string());
  }
  const AnatomyMeasures measures = measure(grown.anatomy, grown.organ);
  nlohmann::ordered_json lost = nlohmann::ordered_json::array();
  if (options.flows) lost = flows(grown.anatomy);
  const TerminalDistance distance = terminalDistance(grown.anatomy, grown.organ);
  if (!options.json.empty()) {
    nlohmann::ordered_json json = toJson(measures);
    if (distance.largest > 0)
      json["to_portal_terminal_mm"] = {{"mean", 1e3 * distance.mean},
                                       {"largest", 1e3 * distance.largest}};
    if (options.flows) json["flows"] = lost;
    if (segments) json["couinaud"] = segmentsJson(grown, *segments);
    writeJson(options.json, json);
    if (isStandardOutput(options.json)) return;
    written.push_back(options.json);
  }
  std::FILE* text = placeForText({options.out});
  int crossings = 0;
  for (int k = 0; k < kVesselKinds; ++k) {
    const VesselMeasures& m = measures.kinds[std::size_t(k)];
    if (m.segments == 0) continue;
    printLine(text,
              "{:<15} {:5} segments, {:4} terminals, {:5.1f} ml, mean radius {:.2f} mm (Strahler "
              "order 1) to {:.2f} mm (order {})",
              nameOf(VesselKind(k)), m.segments, m.terminals, 1e6 * m.volume,
              1e3 * m.radiusByOrder.front(), 1e3 * m.radiusByOrder.back(), m.radiusByOrder.size());
    for (int other = 0; other < k; ++other)
      crossings += measures.crossings[std::size_t(k)][std::size_t(other)];
  }
  printLine(text, "{} pairs of vessels of two kinds cross", crossings);
  if (distance.largest > 0)
    printLine(text,
              "to the nearest end of the portal vein: {:.1f} mm in the mean, {:.1f} mm at most",
              1e3 * distance.mean, 1e3 * distance.largest);
  if (segments) {
    std::string volumes;
    for (int k = 1; const double volume : segmentVolumes(*segments, grown.organ))
      volumes += fmt::format("{}{} {:.0f}", k > 1 ? ", " : "", romanNumber(k), 1e6 * volume), ++k;
    printLine(text, "segments, ml: {}", volumes);
  }
  if (!lost.empty()) {
    printLine(text, "ml/s out of a vessel severed in its middle, at the height of the hilum:");
    printLine(text, "{:<14} {:>10} {:>6} {:>19} {:>16} {:>16}", "", "diameter", "open",
              "all of this width", "clip before it", "inflow clamped");
  }
  for (const auto& row : lost)
    printLine(text, "{:<14} {:7.2f} mm {:6.2f} {:>19} {:16.2f} {:16.2f}",
              row["kind"].get<std::string>(), row["diameter_mm"].get<double>(),
              row["open_ml_s"].get<double>(),
              fmt::format("{:.2f} to {:.2f}", row["least_open_ml_s"].get<double>(),
                          row["most_open_ml_s"].get<double>()),
              row["clipped_ml_s"].get<double>(), row["clamped_ml_s"].get<double>());
  for (const std::string& file : written) printLine(text, "{}", file);
}

}  // namespace

void addAnatomyCommand(Command app) {
  auto options = std::make_shared<AnatomyOptions>();
  Command command = app.subcommand(
      "anatomy", "Show the liver's vessels and segments, or grow or find those of an organ");
  command.option("--organ", options->organ, "Model file of a closed organ to grow vessels into");
  command.option("--unit", options->unit, "Unit of that file: mm, cm, m, in").showDefault();
  command.option("--hilum", options->hilum, "Where portal vein, artery and duct enter: x y z")
      .values(3);
  command.option("--cava", options->cava, "Where the hepatic veins leave: x y z").values(3);
  command.option("--structure", options->structures,
                 "KIND=FILE, a model file of vessels, whose centre lines are taken; may be given "
                 "for each kind. From portal vein and hepatic veins smaller vessels grow");
  command.flag("--only-found", options->onlyFound, "Let no vessels grow from those of --structure");
  command.option("--terminals", options->terminals, "Ends of each tree, 30 to 5000").showDefault();
  command.option("--seed", options->seed, "Another seed gives other vessels").showDefault();
  command.option("-o,--output", options->out, "File to write the vessels to (.vessels)");
  command.option("--meshes", options->meshes,
                 "Folder for a mesh of each kind of vessel, and of the surface of each "
                 "segment (.ply)");
  command.flag("--flows", options->flows, "What vessels of some diameters lose when they are cut");
  command
      .option("--json", options->json,
              "JSON file for the measures; - or nothing for standard output")
      .valueOr("-");
  command.footer(
      "Examples:\n  resect anatomy --meshes trees && resect render trees/*.ply -o trees.png\n"
      "  resect anatomy --meshes trees && resect render trees/segment-*.ply -o segments.png\n"
      "  resect anatomy --organ my_liver.stl --unit mm --hilum 35 -20 10 --cava 35 42 -16 -o "
      "my.vessels\n"
      "  resect anatomy --organ my_liver.stl --structure portal-vein=portal.stl -o my.vessels");
  command.action([options] { anatomy(*options); });
}

}  // namespace resect
