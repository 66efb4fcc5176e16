#include "formats/model_info.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "geometry/measures.h"
#include "geometry/repair/mesh_health.h"
#include "geometry/repair/weld.h"
#include "io/organ_mesh.h"
#include "io/organ_size.h"

namespace resect {

ModelInfo modelInfo(const Model& model) {
  const TriangleMesh mesh = merged(model);
  ModelInfo info;
  info.path = model.path;
  info.format = model.format;
  for (const ModelPart& part : model.parts) info.parts.push_back(part.name);
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
  info.components = health.components;
  info.closed = health.closed;
  info.oriented = health.oriented;
  info.insideOut = health.insideOut;
  info.boundaryEdges = health.boundaryEdges;
  info.nonManifoldEdges = health.nonManifoldEdges;
  if (!isOrganSized(info.bounds)) {
    const std::string unit = plausibleUnit(info.bounds);
    if (unit != "m") info.unitHint = unit;
  }
  return info;
}

nlohmann::ordered_json toJson(const ModelInfo& info) {
  using Json = nlohmann::ordered_json;
  const auto triple = [](const Vec3& p) { return Json{p.x(), p.y(), p.z()}; };
  return {{"file", info.path},
          {"format", info.format},
          {"parts", info.parts},
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
          {"unit_hint", info.unitHint.empty() ? Json() : Json(info.unitHint)}};
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
  if (!info.unitHint.empty())
    line("unit", fmt::format("not the size of an organ; if the file is in {0}, add --unit {0}",
                             info.unitHint));
  if (info.parts.size() > 1) {
    line("parts", fmt::format("{}", info.parts.size()));
    for (const std::string& part : info.parts) text += fmt::format("    {}\n", shownText(part));
  }
  return text;
}

}  // namespace resect
