#include "tools/registry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "tools/parts/aspirator_part.h"
#include "tools/parts/bipolar_part.h"
#include "tools/parts/blade_part.h"
#include "tools/parts/clip_part.h"
#include "tools/parts/gauze_part.h"
#include "tools/parts/grasp_part.h"
#include "tools/parts/hook_part.h"
#include "tools/parts/inflow_clamp_part.h"
#include "tools/parts/jaws_part.h"
#include "tools/parts/pencil_part.h"
#include "tools/parts/remover.h"
#include "tools/parts/suction_part.h"

namespace resect {
namespace {

template <typename Part>
std::unique_ptr<WorkingPart> make() {
  return std::make_unique<Part>();
}

constexpr std::array<PartKind, 12> kPartKinds = {{
    {"blade", make<BladePart>},
    {"jaws", make<JawsPart>},
    {"hook", make<HookPart>},
    {"remover", make<Remover>},
    {"suction", make<SuctionPart>},
    {"clip", make<ClipPart>},
    {"bipolar", make<BipolarPart>},
    {"gauze", make<GauzePart>},
    {"inflow_clamp", make<InflowClampPart>},
    {"pencil", make<PencilPart>},
    {"aspirator", make<AspiratorPart>},
    {"grasp", make<GraspPart>},
}};

template <typename Kinds>
std::string namesOf(const Kinds& kinds) {
  std::string names;
  for (const auto& kind : kinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

std::unique_ptr<WorkingPart> makePart(std::string_view name, const ToolModel& model) {
  const auto kind = std::ranges::find(kPartKinds, name, &PartKind::name);
  if (kind == kPartKinds.end())
    throw error("there is no working part \"{}\" (tool \"{}\"); use one of: {}", name, model.name,
                namesOf(kPartKinds));
  return kind->make();
}

}  // namespace

std::span<const PartKind> partKinds() { return kPartKinds; }

std::span<const ToolKind> toolKinds() {
  static const std::array<ToolKind, 12> kinds = {{
      {"scalpel", {"blade"}},
      {"hook", {"hook"}},
      {"baton", {}},  // blunt: only its shape pushes
      {"scissors", {"jaws"}},
      {"suction", {"suction"}, true},
      {"clip_applier", {"clip"}, true},
      {"bipolar", {"bipolar"}, true},
      {"gauze", {"gauze"}, true},
      {"inflow_clamp", {"inflow_clamp"}, true},
      {"pencil", {"pencil"}, true},
      {"aspirator", {"aspirator"}, true},
      {"forceps", {"grasp"}},
  }};
  return kinds;
}

std::unique_ptr<Tool> makeTool(ToolModel model) {
  auto tool = std::make_unique<Tool>();
  const auto kind = std::ranges::find(toolKinds(), model.kind, &ToolKind::name);
  if (kind == toolKinds().end())
    throw error("there is no kind of tool \"{}\" (tool \"{}\"); use one of: {}", model.kind,
                model.name, namesOf(toolKinds()));
  std::vector<std::string_view> parts(model.parts.begin(), model.parts.end());
  if (parts.empty()) parts = kind->parts;
  if (model.response == "remove") parts = {"remover"};
  for (const std::string_view part : parts) tool->parts.push_back(makePart(part, model));
  require(!model.mesh.triangles.empty(), "tool \"{}\" has no shape; give a closed mesh",
          model.name);
  requireSound(model.mesh);
  const auto finite = [](const Vec3& p) { return p.allFinite(); };
  require(finite(model.tip) && finite(model.axis) && finite(model.point) &&
              std::ranges::all_of(model.edge, finite) && std::ranges::all_of(model.hook, finite) &&
              finite(model.jaws.pivot) && finite(model.jaws.axis) &&
              std::isfinite(model.jaws.opening) && model.contactRadius >= 0 &&
              model.friction >= 0 && model.bluntness >= 0 && model.slipForce >= 0,
          "a length, friction or force of tool \"{}\" is not a number from 0; correct it",
          model.name);
  for (const DrawnPart& part : model.drawn) {
    requireSound(part.mesh);
    require(part.normals.empty() || part.normals.size() == part.mesh.points.size(),
            "a drawn part of tool \"{}\" has {} normals for {} points; give one for each, or none",
            model.name, part.normals.size(), part.mesh.points.size());
  }
  tool->bounds = bounds(model.mesh);
  tool->model = std::move(model);
  return tool;
}

}  // namespace resect
