#include "record/recorded_setup.h"

#include <resect/version.h>

#include "base/error.h"
#include "io/cells/cells_file.h"
#include "io/operation_setup.h"
#include "io/surroundings/surroundings_of.h"
#include "tools/registry.h"

namespace resect {
namespace {

struct Text {
  std::string text;
  template <class Visitor>
  void visit(Visitor& v) {
    v("text", text);
  }
};

// The fields of a ToolModel. Its file is a name for people only.
struct ToolFields {
  ToolModel model;
  std::vector<Text> parts;
  std::string file;

  ToolFields() = default;
  explicit ToolFields(const ToolModel& from) : model(from), file(from.file.filename().string()) {
    for (const std::string& part : model.parts) parts.push_back({part});
  }
  ToolModel value() const {
    ToolModel tool = model;
    tool.file = file;
    tool.parts.clear();
    for (const Text& part : parts) tool.parts.push_back(part.text);
    return tool;
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", model.name), v("kind", model.kind), v("parts", parts);
    v("description", model.description), v("file", file), v("mesh", model.mesh);
    v("tip", model.tip), v("axis", model.axis), v("edge", model.edge), v("jaws", model.jaws);
    v("drawn", model.drawn), v("hook", model.hook), v("point", model.point),
        v("contactRadius", model.contactRadius);
    v("response", model.response), v("friction", model.friction);
    v("slipForce", model.slipForce), v("bluntness", model.bluntness);
  }
};

struct OrganVessels {
  std::vector<VesselSegment> segments;

  template <class Visitor>
  void visit(Visitor& v) {
    v("segments", segments);
  }
};

struct SetupFields {
  Scenario scenario;
  std::vector<ToolFields> tools;
  std::vector<OrganVessels> vessels;
  std::optional<Surroundings> surroundings;

  template <class Visitor>
  void visit(Visitor& v) {
    v("scenario", scenario), v("tools", tools), v("vessels", vessels);
    v("surroundings", surroundings);
  }
};

constexpr std::uint64_t kFingerprint = 0x7265636f72646564;  // "recorded": a setup, no other state

}  // namespace

RecordedSetup setupOf(const Scenario& scenario, const Simulation& simulation) {
  require(scenario.organs.size() == simulation.organs().size() &&
              scenario.tools.size() == simulation.tools().size(),
          "the scenario has {} organs and {} tools, the simulation {} and {}; record the one that "
          "it was made from",
          scenario.organs.size(), scenario.tools.size(), simulation.organs().size(),
          simulation.tools().size());
  RecordedSetup setup{scenario, {}, {}, {}, simulation.surroundings()};
  for (const OperatedOrgan& organ : simulation.organs()) {
    setup.cells.push_back(organ.organ.rest);
    setup.anatomies.push_back(organ.organ.map ? organ.organ.map->anatomy : Anatomy());
  }
  for (const ToolState& tool : simulation.tools()) setup.tools.push_back(tool.tool->model);
  return setup;
}

Simulation simulationOf(const RecordedSetup& setup) {
  const Scenario& scenario = setup.scenario;
  if (setup.cells.size() != scenario.organs.size() || setup.tools.size() != scenario.tools.size() ||
      setup.anatomies.size() != setup.cells.size())
    throw error("the recording's organs or tools are not those of its scenario; it is damaged");
  requireSound(scenario);
  std::vector<OperatedOrgan> organs;
  for (std::size_t i = 0; i < setup.cells.size(); ++i) {
    const ScenarioOrgan& source = scenario.organs[i];
    Organ organ = makeOrgan(setup.cells[i], source.source.settings);
    if (!setup.anatomies[i].empty()) organ.map = makeVesselMap(setup.anatomies[i]);
    std::unique_ptr<TissueModel> tissue = makeTissue(source.tissue, organ);
    organs.push_back(operatedOrgan(source.source.name, std::move(organ), std::move(tissue)));
  }
  std::vector<TissueJoint> joints = makeJoints(scenario, organs);
  std::vector<std::unique_ptr<Tool>> tools;
  for (const ToolModel& tool : setup.tools) tools.push_back(makeTool(tool));
  if (setup.surroundings)
    for (const StandingBody& body : setup.surroundings->bodies) requireSound(body.shape);
  Surroundings surroundings =
      setup.surroundings ? *setup.surroundings : surroundingsBefore(scenario, organs);
  return assemble(scenario, std::move(organs), std::move(joints), std::move(tools),
                  std::move(surroundings));
}

SetupBytes toBytes(const RecordedSetup& setup) {
  SetupFields fields{setup.scenario, {}, {}, setup.surroundings};
  for (const ToolModel& tool : setup.tools) fields.tools.emplace_back(tool);
  for (const Anatomy& anatomy : setup.anatomies) fields.vessels.push_back({anatomy.segments});
  SetupBytes bytes{toBytes(saveState(fields, kFingerprint)), {}};
  for (const Discretization& cells : setup.cells)
    bytes.cells.push_back(formatCells({cells, {"resect " RESECT_VERSION, "recording", 1}}));
  return bytes;
}

RecordedSetup setupFromBytes(const SetupBytes& bytes) {
  const SavedState state = stateFromBytes(bytes.scenario);
  if (state.fingerprint != kFingerprint)
    throw error("the recording holds no scenario; it is damaged");
  SetupFields fields;
  loadState(fields, state);
  RecordedSetup setup{std::move(fields.scenario), {}, {}, {}, std::move(fields.surroundings)};
  for (const ToolFields& tool : fields.tools) setup.tools.push_back(tool.value());
  for (OrganVessels& vessels : fields.vessels)
    setup.anatomies.push_back(makeAnatomy(std::move(vessels.segments)));
  for (const std::string& cells : bytes.cells)
    setup.cells.push_back(parseCells(cells, "the recording's organ").cells);
  return setup;
}

}  // namespace resect
