#include "formats/model_info.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "geometry/measures.h"
#include "geometry/repair/mesh_health.h"
#include "geometry/repair/weld.h"
#include "io/organ_mesh.h"
#include "io/organ_size.h"

namespace resect {

namespace {

PartInfo partInfo(const ModelPart& part, const WeldedSurface& welded) {
  PartInfo info{part.name, int(part.mesh.triangles.size())};
  info.closed = welded.topology.closed() && !welded.mesh.triangles.empty();
  info.boundaryEdges = welded.topology.boundaryEdges;
  if (info.closed) info.volume = std::abs(volumeAbout(welded.mesh, bounds(welded.mesh).centre()));
  return info;
}

std::string inWords(const PartInfo& part) {
  return fmt::format("{}: {} triangles, {}", part.name.empty() ? "(no name)" : shownText(part.name),
                     part.triangles,
                     part.closed ? fmt::format("closed, {:.6g} ml", part.volume * 1e6)
                                 : fmt::format("open, {} boundary edges", part.boundaryEdges));
}

}  // namespace

ModelInfo modelInfo(const Model& whole, const OrganMeshOptions& options) {
  const Model model = chosenParts(whole, options.part);
  const TriangleMesh mesh = chosenSurface(model, "", options.metresPerUnit);
  ModelInfo info;
  info.path = model.path;
  info.format = model.format;
  info.triangles = int(mesh.triangles.size());
  info.area = area(mesh);
  info.volume = volume(mesh);
  WeldReport report;
  weld(mesh, 0, &report);
  info.vertices = int(mesh.points.size()) - report.mergedPoints - report.unusedPoints;
  // Points without a triangle are not counted.
  for (const Triangle& t : mesh.triangles)
    for (const std::int32_t i : t) info.bounds.grow(mesh.points[i]);

  const WeldedSurface welded = weldSurface(mesh);
  const MeshHealth health = examine(welded.mesh, welded.topology);
  for (const ModelPart& part : model.parts) {
    const Model alone{model.path, model.format, {part}};
    info.parts.push_back(
        partInfo(part, model.parts.size() == 1
                           ? welded
                           : weldSurface(chosenSurface(alone, "", options.metresPerUnit))));
  }
  info.components = health.components;
  info.closed = health.closed;
  info.oriented = health.oriented;
  info.insideOut = health.insideOut;
  info.boundaryEdges = health.boundaryEdges;
  info.nonManifoldEdges = health.nonManifoldEdges;
  info.unitHint = unitHint(info.bounds, options.metresPerUnit);
  try {
    OrganMesh organ = prepareOrganMesh(whole, options);
    info.organVolume = organ.volume;
    info.cavities = int(std::ranges::count(organ.shells, ShellKind::Cavity, &Shell::kind));
    info.shellsWithin = int(std::ranges::count(organ.shells, ShellKind::Within, &Shell::kind));
    info.notes = std::move(organ.notes);
  } catch (const Error& e) {
    info.refusal = e.what();
  }
  return info;
}

nlohmann::ordered_json toJson(const ModelInfo& info) {
  using Json = nlohmann::ordered_json;
  const auto triple = [](const Vec3& p) { return Json{p.x(), p.y(), p.z()}; };
  Json names = Json::array(), parts = Json::array();
  for (const PartInfo& part : info.parts) {
    names.push_back(part.name);
    parts.push_back({{"name", part.name},
                     {"triangles", part.triangles},
                     {"closed", part.closed},
                     {"boundary_edges", part.boundaryEdges},
                     {"volume_ml", part.closed ? Json(part.volume * 1e6) : Json()}});
  }
  return {{"file", info.path},
          {"format", info.format},
          {"parts", names},
          {"part_health", parts},
          {"triangles", info.triangles},
          {"vertices", info.vertices},
          {"area_m2", info.area},
          {"volume_ml", info.volume * 1e6},
          {"bounds_m", {triple(info.bounds.min), triple(info.bounds.max)}},
          {"components", info.components},
          {"closed", info.closed},
          {"oriented", info.oriented},
          {"inside_out", info.insideOut},
          {"boundary_edges", info.boundaryEdges},
          {"non_manifold_edges", info.nonManifoldEdges},
          {"unit_hint", info.unitHint.empty() ? Json() : Json(info.unitHint)},
          {"organ_ml", info.organVolume ? Json(*info.organVolume * 1e6) : Json()},
          {"cavities", info.cavities},
          {"shells_within", info.shellsWithin},
          {"notes", info.notes},
          {"refusal", info.refusal.empty() ? Json() : Json(info.refusal)}};
}

std::string toText(const ModelInfo& info) {
  const auto yes = [](bool value) { return value ? "yes" : "no"; };
  const Vec3 size = info.bounds.size();
  std::string text =
      fmt::format("{}: {}\n", shownText(info.path, kLongestShownPath), shownText(info.format));
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<16}{}\n", name, value);
  };
  line("triangles", fmt::format("{}", info.triangles));
  line("vertices", fmt::format("{}", info.vertices));
  line("size", fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.x(), size.y(), size.z()));
  line("bounds", fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m",
                             info.bounds.min.x(), info.bounds.min.y(), info.bounds.min.z(),
                             info.bounds.max.x(), info.bounds.max.y(), info.bounds.max.z()));
  line("area", fmt::format("{:.6g} m^2", info.area));
  line("volume", fmt::format("{:.6g} ml{}", info.volume * 1e6,
                             info.closed ? "" : " (open: depends on where the origin is)"));
  line("components", fmt::format("{}", info.components));
  line("closed", info.closed ? "yes" : fmt::format("no, {} boundary edges", info.boundaryEdges));
  line("oriented", yes(info.oriented));
  line("inside out", yes(info.insideOut));
  if (info.nonManifoldEdges > 0)
    line("non-manifold", fmt::format("{} edges of more than two triangles", info.nonManifoldEdges));
  if (info.organVolume) line("as an organ", fmt::format("{:.6g} ml", *info.organVolume * 1e6));
  if (!info.refusal.empty()) {
    // The sentence begins with the file, which is said above.
    std::string_view why = info.refusal;
    if (why.starts_with(info.path + ": ")) why.remove_prefix(info.path.size() + 2);
    line("as an organ", "refused: " + shownSentence(why));
  }
  for (const std::string& note : info.notes) line("note", shownSentence(note));
  if (info.parts.size() > 1) {
    line("parts", fmt::format("{}", info.parts.size()));
    for (const PartInfo& part : info.parts) text += fmt::format("    {}\n", inWords(part));
  }
  return text;
}

}  // namespace resect
