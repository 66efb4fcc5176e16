#include "io/scenario/scenario_file.h"

#include <algorithm>

#include "base/error.h"
#include "io/data_folder.h"
#include "io/model.h"
#include "io/scenario/label_reader.h"
#include "io/scenario/length.h"
#include "io/scenario/region_reader.h"
#include "io/scenario/task_reader.h"
#include "io/scenario/toml_table.h"
#include "io/scenario/way_reader.h"
#include "operation/promises.h"
#include "operation/room.h"

namespace resect {
namespace {

constexpr std::size_t kMostOrgans = 100, kMostTools = 100;

Vec3i readDims(const TomlTable& t) {
  const Vec3 dims = t.vec3("dims");
  for (int a = 0; a < 3; ++a)
    if (dims[a] < 1 || dims[a] > 2000 || dims[a] != std::floor(dims[a]))
      t.complain("dims", "is not three whole numbers from 1 to 2000");
  return dims.cast<int>();
}

OrganWound readWound(const TomlTable& t) {
  OrganWound wound;
  const std::string frame = t.text("frame", "organ");
  if (frame != "organ" && frame != "world")
    t.complain("frame", "is \"" + frame + "\"; use \"organ\" or \"world\"");
  wound.inWorld = frame == "world";
  wound.from = t.place("from", ranges::kFarthestPose);
  wound.to = t.place("to", ranges::kFarthestPose);
  if ((wound.to - wound.from).norm() < 1e-6) t.complain("to", "is where `from` is; give a line");
  const Vec3 into = t.place("into", ranges::kFarthestPose, wound.into);
  if (into.norm() < 1e-6) t.complain("into", "has no length; give a direction");
  wound.into = into.normalized();
  wound.depth = t.number("depth", 1e-4, 1);
  t.refuseUnknownKeys();
  return wound;
}

OrganSource readOrgan(const TomlTable& t) {
  OrganSource organ;
  organ.name = t.text("name", "organ");
  organ.beside = t.text("beside", "");
  const std::string source = t.text("source", "liver");
  organ.file = source;
  organ.part = partLines(t.isList("part") ? t.texts("part") : partNames(t.text("part", "")));
  organ.unit = parseUnit(t.text("unit", "m"), "organ.unit");
  organ.repair = t.flag("repair", false);
  const bool chosen = t.isText("spacing") && t.text("spacing") == "auto";
  if (t.has("spacing") && !chosen)
    organ.spacing = t.length("spacing", ranges::kSpacing.low, ranges::kSpacing.high);
  if (t.has("dims")) organ.dims = readDims(t);
  if ((organ.spacing || chosen) && organ.dims)
    t.complain("dims", "and spacing are both given; keep one");
  if (!organ.spacing && !organ.dims && !chosen) organ.spacing = 0.005;
  organ.pose = {t.place("position", ranges::kFarthestPose, Vec3::Zero()), t.rotation("rotation")};
  organ.onTable = t.flag("on_table", true);
  organ.settle = t.flag("settle", true);
  organ.settings.refine = t.integer("refine", 1, 4, organ.settings.refine);
  organ.settings.iso = float(t.number("iso", kMinIso, kMaxIso, organ.settings.iso));
  organ.vessels = t.text("vessels", "");
  if (organ.vessels == kBuiltInVessels && !hasVessels(organ))
    t.complain("vessels", "is \"built-in\", and \"" + organ.file +
                              "\" comes without vessels; name a file of vessels, or take an organ "
                              "that has them: " +
                              organsWithVessels());
  organ.smallVessels = t.flag("small_vessels", true);
  organ.landmarks = readLandmarks(t);
  readLabels(t, organ);
  for (const TomlTable& wound : t.tables("wound")) organ.wounds.push_back(readWound(wound));
  return organ;
}

std::string readResponse(const TomlTable& t) {
  const std::string response = t.text("response", "own");
  if (response != "own" && response != "remove")
    t.complain("response", "is \"" + response + "\"; use \"own\" or \"remove\"");
  return response == "own" ? "" : response;
}

TissueAttachment readAttachment(const TomlTable& t) {
  TissueAttachment attachment;
  const std::string kind = t.text("kind", "pin");
  if (kind != "pin" && kind != "ligament")
    t.complain("kind", "is \"" + kind + "\"; use \"pin\" or \"ligament\"");
  attachment.kind = kind == "pin" ? TissueAttachment::Kind::Pin : TissueAttachment::Kind::Ligament;
  static_cast<Region&>(attachment) = readRegion(t);
  attachment.stiffness = t.number("stiffness", ranges::kSpringStiffness, attachment.stiffness);
  t.refuseUnknownKeys();
  return attachment;
}

TissueSetup readTissue(const TomlTable& t) {
  TissueSetup tissue;
  const std::string model = t.text("model", "still");
  if (model != "still" && model != "elastic")
    t.complain("model", "is \"" + model + "\"; use \"still\" or \"elastic\"");
  tissue.elastic = model == "elastic";
  if (t.flag("plain", false)) {
    tissue.material.stiffening = 0;
    tissue.material.branches.clear();
    tissue.material.capsule = tissue.material.capsuleTension = 0;
    tissue.material.cutEnergy = tissue.material.capsuleCutEnergy = 0;
  }
  tissue.material = readMaterial(t, tissue.material, tissue.notes);
  tissue.materials = readMaterials(t, tissue.material, tissue.notes);
  tissue.settings.gravity = {0, -t.number("gravity", ranges::kGravity, 9.81), 0};
  tissue.settings.damping = t.number("damping", ranges::kDamping, tissue.settings.damping);
  tissue.settings.drag = t.number("drag", ranges::kDrag, 0.3);
  tissue.settings.threads = t.integer("threads", 0, 64, 0);
  for (const TomlTable& attachment : t.tables("attachment"))
    tissue.attachments.push_back(readAttachment(attachment));
  t.refuseUnknownKeys();
  return tissue;
}

Breathing readBreathing(const TomlTable& t) {
  Breathing breathing;
  breathing.depth = t.length("depth", ranges::kBreathDepth.low, ranges::kBreathDepth.high);
  breathing.perMinute = t.number("per_minute", ranges::kBreathRate, breathing.perMinute);
  breathing.bed = t.number("bed", ranges::kBed, breathing.bed);
  breathing.begins = t.flag("begins", breathing.begins);
  t.refuseUnknownKeys();
  return breathing;
}

ScenarioTool readScenarioTool(const TomlTable& t, int number,
                              const std::vector<ScenarioOrgan>& organs) {
  ScenarioTool tool;
  tool.model = t.text("model");
  if (t.has("response")) tool.response = readResponse(t);
  tool.rest = toolBoxPlace(number);
  if (const auto rest = t.table("rest")) {
    tool.rest = {rest->place("position", ranges::kFarthestPose), rest->rotation("rotation")};
    rest->refuseUnknownKeys();
  }
  const std::string frame = t.text("frame", "world");
  if (frame != "world" && frame != "organ")
    t.complain("frame", "is \"" + frame + "\"; use \"world\" or \"organ\"");
  if (frame == "organ") {
    tool.way = readWay(t, organs);
    t.refuseUnknownKeys();
    return tool;
  }
  for (const TomlTable& key : t.tables("keys", kMostKeys)) {
    const double time = key.number("time", ranges::kKeyTime);
    if (!tool.keys.empty() && time <= tool.keys.back().time)
      key.complain("time", "is not later than that of the key before");
    tool.keys.push_back({time,
                         {key.place("position", ranges::kFarthestPose), key.rotation("rotation")},
                         key.number("squeeze", 0, 1, 0),
                         key.number("pedal", 0, 1, 0)});
    key.refuseUnknownKeys();
  }
  t.refuseUnknownKeys();
  return tool;
}

// Default: thesis mode if the tissue is still.
OperationMode readMode(const TomlTable& t, bool elastic) {
  const std::string mode = t.text("mode", elastic ? "operation" : "thesis");
  if (mode != "thesis" && mode != "operation")
    t.complain("mode", "is \"" + mode + "\"; use \"thesis\" or \"operation\"");
  if (mode == "thesis" && elastic)
    t.complain("mode",
               "is \"thesis\", where tissue is still; leave it out, or set model = \"still\"");
  return mode == "thesis" ? OperationMode::Thesis : OperationMode::Operation;
}

// One [organ] with [tissue], or any number of [[organ]], each with its own [organ.tissue] or else
// with [tissue].
void readOrgans(const TomlTable& t, Scenario& scenario) {
  TissueSetup common;
  if (const auto tissue = t.table("tissue")) common = readTissue(*tissue);
  const auto read = [&](const TomlTable& organ) {
    ScenarioOrgan one{readOrgan(organ), common};
    if (const auto tissue = organ.table("tissue")) one.tissue = readTissue(*tissue);
    organ.refuseUnknownKeys();
    return one;
  };
  std::vector<ScenarioOrgan> organs;
  if (t.isList("organ"))
    for (const TomlTable& organ : t.tables("organ", kMostOrgans)) {
      organs.push_back(read(organ));
      const std::string& name = organs.back().source.name;
      if (std::ranges::count(organs, name, [](const auto& o) { return o.source.name; }) > 1)
        organ.complain("name",
                       "is \"" + name + "\", as another organ's; give each a name of its own");
    }
  else if (const auto organ = t.table("organ"))
    organs.push_back(read(*organ));
  if (organs.empty()) {
    organs.push_back({{}, common});
    organs[0].source.spacing = 0.005;
  }
  const auto known = [&](const std::string& name) {
    return std::ranges::any_of(organs, [&](const auto& o) { return o.source.name == name; });
  };
  for (std::size_t i = 0; i < organs.size(); ++i)
    if (const std::string& beside = organs[i].source.beside; !beside.empty()) {
      const bool before = std::any_of(organs.begin(), organs.begin() + std::ptrdiff_t(i),
                                      [&](const auto& o) { return o.source.name == beside; });
      if (!before)
        t.tables("organ", kMostOrgans)[i].complain(
            "beside", "is \"" + beside + "\", which is no organ before this one");
    }
  for (const TomlTable& joint : t.tables("joint")) {
    OrganJoint one;
    const std::vector<std::string> names = joint.texts("organs");
    if (names.size() != 2 || names[0] == names[1] || !known(names[0]) || !known(names[1]))
      joint.complain("organs", "is not the names of two organs; give organs = [\"...\", \"...\"]");
    one.organs[0] = names[0];
    one.organs[1] = names[1];
    if (joint.has("reach"))
      one.reach = joint.length("reach", ranges::kJointReach.low, ranges::kJointReach.high);
    one.stiffness = joint.number("stiffness", ranges::kSpringStiffness, one.stiffness);
    joint.refuseUnknownKeys();
    scenario.joints.push_back(one);
  }
  scenario.organs = std::move(organs);
  scenario.mode = readMode(t, moves(scenario));
}

Scenario toScenario(const TomlTable& t) {
  Scenario scenario;
  scenario.title = t.text("title");
  scenario.description = t.freeText("description");
  scenario.promises = t.texts("promises");
  for (const std::string& word : scenario.promises)
    if (std::ranges::find(kPromises, word, &PromiseKind::word) == kPromises.end()) {
      std::string known;
      for (const PromiseKind& kind : kPromises)
        known += (known.empty() ? "" : ", ") + std::string(kind.word);
      t.complain("promises", "has \"" + word + "\"; use some of these: " + known);
    }
  scenario.frameRate = t.number("frame_rate", ranges::kFrameRate, 60);
  if (t.has("after")) {
    scenario.after = t.number("after", 0, ranges::kDuration.high);
    if (t.has("duration")) t.complain("after", "and duration are both given; keep one");
  } else {
    scenario.duration = t.number("duration", ranges::kDuration);
  }
  scenario.view = t.text("view", "surgeon");
  if (t.has("close_up")) {
    scenario.closeUp = readBox(t, "close_up", "close_up = [[x, y, z], [x, y, z]]");
    if (!(scenario.closeUp->size().maxCoeff() > 0)) t.complain("close_up", "has no size");
  }
  readOrgans(t, scenario);
  if (const auto breathing = t.table("breathing")) {
    scenario.breathing = readBreathing(*breathing);
    if (scenario.breathing.depth > 0 && !moves(scenario))
      breathing->complain("depth",
                          "is above 0, and no organ is elastic; set model = \"elastic\" in "
                          "[tissue], or a depth of 0");
  }
  if (const auto room = t.table("room")) {
    scenario.table = room->flag("table", true);
    scenario.toolBox = room->flag("tool_box", true);
    scenario.setting = room->text("setting", "table");
    if (!isSetting(scenario.setting))
      room->complain("setting",
                     fmt::format("is \"{}\"; choose {}", scenario.setting, kSettingNames));
    room->refuseUnknownKeys();
  }
  for (const TomlTable& tool : t.tables("tool", kMostTools))
    scenario.tools.push_back(readScenarioTool(tool, int(scenario.tools.size()), scenario.organs));
  endAfterKeys(scenario);
  if (const auto task = t.table("task")) scenario.task = readTask(*task, scenario);
  t.refuseUnknownKeys();
  return scenario;
}

// A file named in another one: relative to that file if it exists there, else as named.
std::string resolved(const std::string& name, const std::filesystem::path& from) {
  std::error_code ec;
  const auto beside = from.parent_path() / name;
  return std::filesystem::is_regular_file(beside, ec) ? beside.string() : name;
}

}  // namespace

Scenario readScenario(const std::filesystem::path& path) {
  Scenario scenario = toScenario(TomlTable::readFile(path));
  scenario.name = path.stem().string();
  scenario.file = path.string();
  for (ScenarioOrgan& organ : scenario.organs) {
    if (!isBuiltIn(organ.source)) organ.source.file = resolved(organ.source.file, path);
    if (isVesselsFile(organ.source)) organ.source.vessels = resolved(organ.source.vessels, path);
    for (BroughtStructure& one : organ.source.structures) one.file = resolved(one.file, path);
  }
  for (ScenarioTool& tool : scenario.tools) tool.model = resolved(tool.model, path);
  return scenario;
}

Scenario parseScenario(const std::string& text, const std::string& name) {
  Scenario scenario = toScenario(TomlTable::parse(text, name));
  scenario.name = name;
  return scenario;
}

namespace {

ToolModel toTool(const TomlTable& t, const std::filesystem::path& folder,
                 const MeshReader& readMesh) {
  ToolModel model;
  model.name = t.text("name");
  model.kind = t.text("kind");
  model.description = t.freeText("description");
  model.tip = t.place("tip", ranges::kFarthestToolPoint, Vec3::Zero());
  model.axis = t.vec3("axis", Vec3::UnitZ());
  if (model.axis.norm() < 1e-9) t.complain("axis", "has no length");
  model.axis.normalize();
  model.edge = t.points("edge", ranges::kFarthestToolPoint);
  model.hook = t.points("hook", ranges::kFarthestToolPoint);
  model.jaws.pivot = t.place("jaw_pivot", ranges::kFarthestToolPoint, Vec3::Zero());
  model.jaws.axis = t.vec3("jaw_axis", Vec3::UnitX());
  if (model.jaws.axis.norm() < 1e-9) t.complain("jaw_axis", "has no length");
  model.jaws.axis.normalize();
  model.jaws.opening = t.number("jaw_opening", ranges::kJawOpening, 0);
  model.point = t.place("point", ranges::kFarthestToolPoint, Vec3::Zero());
  model.contactRadius = t.number("contact_radius", ranges::kContactRadius, 0);
  model.parts = t.texts("parts");
  model.response = readResponse(t);
  model.friction = t.number("friction", ranges::kFriction, model.friction);
  model.slipForce = t.number("slip_force", ranges::kSlipForce, model.slipForce);
  model.bluntness = t.number("bluntness", ranges::kBluntness, model.bluntness);
  model.file = folder / t.text("model");
  t.refuseUnknownKeys();
  model.mesh = readMesh(model.file);
  return model;
}

}  // namespace

ToolModel readTool(const std::filesystem::path& path, const MeshReader& readMesh) {
  return toTool(TomlTable::readFile(path), path.parent_path(), readMesh);
}

ToolModel parseTool(const std::string& text, const std::string& name, const MeshReader& readMesh) {
  return toTool(TomlTable::parse(text, name), {}, readMesh);
}

}  // namespace resect
