#include "io/operation_setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "base/error.h"
#include "collision/coarsest_cell.h"
#include "collision/wall_thickness.h"
#include "geometry/resting_pose.h"
#include "io/cells/particle_file.h"
#include "io/data_folder.h"
#include "io/drawn_parts.h"
#include "io/organ_mesh.h"
#include "io/organ_size.h"
#include "io/plain_mesh.h"
#include "io/scenario/length.h"
#include "io/scenario/scenario_file.h"
#include "io/structures.h"
#include "io/surroundings/surroundings_of.h"
#include "operation/first_wounds.h"
#include "operation/frame_estimate.h"
#include "operation/setting_ranges.h"
#include "operation/way/place_ways.h"
#include "organ/cell_labels.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "organ/region_placer.h"
#include "organ/tissue_cells.h"
#include "tissue/still_tissue.h"
#include "tools/registry.h"

namespace resect {
namespace {

// The surface of an organ that comes along: made once by tools/make_organs, since its formula takes
// 0.7 s.
TriangleMesh builtInMesh(const std::string& name) {
  return merged(readPlainMesh(dataFolder() / "organs" / (name + ".ply")));
}

// A spacing as it is given to --spacing, not rounded up: "1.6mm".
std::string spacingText(double metres) {
  const double step = metres >= 1e-3 ? 0.1 : 0.01;  // mm
  return fmt::format("{:g}mm", std::max(step, step * std::floor(1e3 * metres / step + 1e-6)));
}

// Tells of walls that are thinner than two cells of side `cell`, m. Throws Error if half of the
// tissue would be lost.
void tellThinWalls(const TriangleMesh& surface, const OrganSource& source, double cell,
                   std::vector<std::string>* notes) {
  if (isBuiltIn(source)) return;  // its cells are chosen for it
  const WallThickness walls = wallThickness(surface);
  const double thin = walls.at(0.05);
  if (thin >= 2 * cell) return;
  const std::string measured =
      fmt::format("behind 5 % of its surface lies no more than {} of tissue (behind half of it {})",
                  lengthText(thin), lengthText(walls.at(0.5)));
  constexpr double kMostLost = 0.02;
  const double lost = walls.lostAt(cell);
  if (lost > 0.5)
    throw error("{}: {}; cells of {} would lose {:.0f} % of it; use --spacing {}, which keeps 98 %",
                source.file, measured, lengthText(cell), 100 * lost,
                spacingText(walls.cellFor(kMostLost)));
  if (!notes) return;
  if (lost > kMostLost)
    notes->push_back(fmt::format("{}; cells of {} lose {:.0f} % of it, --spacing {} keeps 98 %",
                                 measured, lengthText(cell), 100 * lost,
                                 spacingText(walls.cellFor(kMostLost))));
  else
    notes->push_back(fmt::format("{}, less than two cells of {}; --spacing {} gives it two",
                                 measured, lengthText(cell), spacingText(thin / 2)));
}

// Samples a closed surface with the source's spacing or dims.
Discretization sample(const TriangleMesh& surface, const OrganSource& source,
                      const Progress& progress, std::vector<std::string>* notes) {
  const Aabb box = bounds(surface);
  double spacing = source.spacing ? *source.spacing : coarsestCell(surface);
  if (const double many = coarsestCellOfMany(surface); source.finerIfSmall && many < spacing) {
    spacing = many;
    if (notes)
      notes->push_back(fmt::format("a small organ: cells of {} make about {:.0f} particles",
                                   lengthText(spacing), kFewestParticles));
  }
  const Lattice lattice =
      source.dims ? latticeForDims(box, *source.dims) : latticeForSpacing(box, spacing);
  if (!source.dims && !source.spacing && notes)
    notes->push_back(
        fmt::format("cells of {}, the largest that keep {:.0f} % of the tissue and "
                    "make about {:.0f} particles",
                    lengthText(spacing), 100 * (1 - kMostLostTissue), kFewestParticles));
  tellThinWalls(surface, source, lattice.spacing.maxCoeff(), notes);
  Discretization cells = discretize(surface, lattice, progress);
  if (cells.particleCount() == 0)
    throw error(
        "no cell centre of the lattice lies inside {}; use smaller cells (--spacing, --dims)",
        source.file);
  if (constexpr double kFew = 0.25 * kFewestParticles;
      notes && source.spacing && !isBuiltIn(source) && double(cells.particleCount()) < kFew)
    notes->push_back(fmt::format(
        "cells of {} make only {} particles, which hardly show its shape; --spacing auto takes {}",
        lengthText(spacing), cells.particleCount(), lengthText(coarsestCell(surface))));
  fitSurface(surface, cells);
  return cells;
}

// Calls make(). To an Error of it the doubt about the organ's size is added, if any: it may be the
// cause that the organ has too many cells, or none where the scenario looks for them.
template <typename Make>
auto doubting(const OrganSource& source, const Aabb& organ, const Make& make) {
  try {
    return make();
  } catch (const Error& e) {
    throw withDoubt(e, isBuiltIn(source) ? "" : sizeDoubt(organ, source.unit));
  }
}

// Tumours are about three times as stiff as the liver round them: medians of 20.2 kPa (malignant
// lesions, 10.1186/s43055-020-00186-2) and 6.6 kPa (liver, 10.1177/8756479317733713), both by shear
// waves.
constexpr double kTumourStiffness = 3;

// The setup's materials, and that of tumours for which it has none.
std::vector<LabelMaterial> materialsOf(const TissueSetup& setup, const Discretization& cells) {
  const auto particles = labelledParticles(cells);
  for (const LabelMaterial& one : setup.materials) {
    if (particles[std::size_t(one.label)] > 0) continue;
    std::string known;
    for (int other = 1; other < 256; ++other)
      if (particles[std::size_t(other)] > 0)
        known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", other, cells.labelName(other));
    throw error("there is a material for label {}, which no particle of the organ has; {}",
                one.label, known.empty() ? "mark cells by [[organ.label]]" : "labels are " + known);
  }
  std::vector<LabelMaterial> materials = setup.materials;
  for (int label = 1; label < 256; ++label) {
    if (particles[std::size_t(label)] == 0 ||
        structureKind(cells.labelName(label)) != StructureKind::Tumour ||
        std::ranges::find(materials, label, &LabelMaterial::label) != materials.end())
      continue;
    LabelMaterial tumour{label, setup.material};
    tumour.material.name = cells.labelName(label);
    tumour.material.young = std::min(kTumourStiffness * tumour.material.young, ranges::kYoung.high);
    materials.push_back(std::move(tumour));
  }
  return materials;
}

}  // namespace

TriangleMesh loadOrganMesh(const OrganSource& source, const ModelReader& readModel,
                           std::vector<std::string>* notes, std::optional<Pose>* place) {
  requireSound(source);
  if (notes) notes->insert(notes->end(), source.notes.begin(), source.notes.end());
  TriangleMesh mesh;
  if (isBuiltIn(source)) {
    mesh = builtInMesh(source.file);
  } else {
    std::vector<std::string> structures;
    for (const BroughtStructure& one : source.structures)
      if (one.file == source.file) structures.push_back(one.part);
    const Model model = readModel(source.file, source.part);
    const OrganMesh organ =
        prepareOrganMesh(model, {source.part, source.repair, source.unit, partLines(structures)});
    mesh = organ.mesh;
    if (notes) {
      notes->insert(notes->end(), organ.notes.begin(), organ.notes.end());
      if (const std::string note = namedStructuresNote(model, source); !note.empty())
        notes->push_back(note);
    }
  }
  mesh = hollowed(std::move(mesh), source, readModel, notes);
  if (place && *place) return transformed(std::move(mesh), **place);
  Eigen::Quaterniond turn = source.pose.rotation;
  mesh = transformed(std::move(mesh), {Vec3::Zero(), turn});
  if (source.onTable && source.settle) {
    const Eigen::Quaterniond settled = restingRotation(mesh);
    mesh = transformed(mesh, {Vec3::Zero(), settled});
    turn = settled * turn;
  }
  const Vec3 shift = placedBy(source, bounds(mesh));
  if (place) *place = Pose{shift, turn};
  return transformed(std::move(mesh), {shift, Eigen::Quaterniond::Identity()});
}

namespace {

// The cells with the labels of their file, if any.
Discretization sourceCells(const OrganSource& source, const ModelReader& readModel,
                           const Progress& progress, std::vector<std::string>* notes,
                           std::optional<Pose>* place, TriangleMesh& surface) {
  if (!isParticleFile(source.file)) {
    surface = loadOrganMesh(source, readModel, notes, place);
    return doubting(source, bounds(surface),
                    [&] { return sample(surface, source, progress, notes); });
  }
  if (!source.beside.empty())
    throw usageError("{} holds particles, which lie as their file says; leave out beside",
                     source.file);
  if (std::ranges::find(source.structures, StructureKind::Cavity, &BroughtStructure::kind) !=
      source.structures.end())
    throw usageError("{} holds particles: cavities are taken from a model file; leave them out",
                     source.file);
  if (!source.part.empty() || source.repair)
    throw usageError("{} holds particles: it has no parts and needs no repair; leave {} out",
                     source.file, source.repair ? "--repair" : "--part");
  Discretization cells = readParticleFile(source.file, source.unit).cells;
  cells.lattice.origin += placedBy(source, cells.lattice.box());
  if (!source.resample) return cells;
  const std::int64_t before = cells.particleCount();
  const Organ organ = makeOrgan(std::move(cells), {});
  surface = organ.surface.mesh();
  if (surface.triangles.empty())
    throw error("{} has no surface to sample anew; make it from a mesh", source.file);
  if (notes) notes->push_back(fmt::format("sampled anew from the surface of {} particles", before));
  Discretization anew = sample(surface, source, progress, notes);
  carryLabels(organ.rest, anew);
  return anew;
}

}  // namespace

Discretization loadCells(const OrganSource& source, const ModelReader& readModel,
                         const Progress& progress, std::vector<std::string>* notes,
                         std::optional<Pose>* place, TriangleMesh* surface) {
  requireSound(source);
  std::optional<Pose> own;
  if (!place) place = &own;
  TriangleMesh sampled;
  Discretization cells = sourceCells(source, readModel, progress, notes, place, sampled);
  if (surface) *surface = std::move(sampled);
  doubting(source, particleBox(cells), [&] { addLabels(cells, source, *place, readModel, notes); });
  return cells;
}

ToolModel loadTool(const std::string& name, const ModelReader& readModel) {
  Model shape;
  const auto readMesh = [&](const std::filesystem::path& path) {
    shape = readModel(path, {});
    return prepareOrganMesh(shape).mesh;
  };
  ToolModel tool = readTool(findDataFile(name, "tools", ".toml"), readMesh);
  tool.drawn = drawnParts(shape, tool.jaws);
  return tool;
}

std::vector<std::unique_ptr<Tool>> loadTools(const Scenario& scenario,
                                             const ModelReader& readModel) {
  std::vector<std::unique_ptr<Tool>> tools;
  for (const ScenarioTool& tool : scenario.tools) {
    ToolModel model = loadTool(tool.model, readModel);
    if (tool.response) model.response = *tool.response;
    if (scenario.mode == OperationMode::Thesis) model.response = "remove";
    tools.push_back(makeTool(std::move(model)));
  }
  return tools;
}

std::unique_ptr<TissueModel> makeTissue(const TissueSetup& setup, const Organ& organ,
                                        std::vector<std::string>* notes) {
  requireSound(setup);
  const std::vector<LabelMaterial> materials = materialsOf(setup, organ.rest);
  if (!setup.elastic) return std::make_unique<StillTissue>(organ.rest.lattice, organ.alive);
  TissueCells cells = tissueCells(organ.rest, setup.material);
  std::array<std::uint8_t, 256> numbers{};  // of the materials, by label
  for (const LabelMaterial& one : materials) {
    numbers[std::size_t(one.label)] = std::uint8_t(cells.materials.size());
    cells.materials.push_back(one.material);
  }
  if (!materials.empty())
    for (const std::uint8_t label : organ.rest.label) cells.material.push_back(numbers[label]);
  auto tissue = std::make_unique<ElasticTissue>(cells, setup.settings);
  RegionPlacer place(organ.rest);
  for (std::size_t i = 0; i < setup.attachments.size(); ++i) {
    TissueAttachment attachment = setup.attachments[i];
    static_cast<Region&>(attachment) = place(attachment);
    if (tissue->attach(attachment) > 0) continue;
    if (setup.attachments[i].frame != Region::Frame::Organ)
      throw error(
          "attachment {} of the tissue holds no particle; move or enlarge its region (the organ at "
          "rest fills {}), or take a scenario that fits any organ: cut, incise, press",
          i + 1, boxText(particleBox(organ.rest)));
    if (notes)
      notes->push_back(fmt::format(
          "a ligament of the scenario (attachment {}) was left out: this organ has no tissue there",
          i + 1));
  }
  return tissue;
}

std::vector<OperatedOrgan> loadOrgans(Scenario& scenario, const ModelReader& readModel,
                                      const Progress& progress, std::vector<std::string>* notes) {
  requireSound(scenario);
  std::vector<OperatedOrgan> organs;
  std::map<std::string, std::optional<Pose>> places;
  for (std::size_t i = 0; i < scenario.organs.size(); ++i) {
    const OrganSource& source = scenario.organs[i].source;
    const std::vector<std::string>& said = scenario.organs[i].tissue.notes;
    if (notes) notes->insert(notes->end(), said.begin(), said.end());
    std::optional<Pose>& place = places[source.name];
    if (!source.beside.empty()) place = places[source.beside];
    if (!source.beside.empty() && !place)
      throw error(
          "organ \"{}\" is beside \"{}\", which holds particles and lies as its file says; leave "
          "out beside and give it a position",
          source.name, source.beside);
    const Progress share = [&](double done) {
      return progress((double(i) + done) / double(scenario.organs.size()));
    };
    TriangleMesh surface;
    Organ organ = makeOrgan(
        loadCells(source, readModel, progress ? share : Progress(), notes, &place, &surface),
        source.settings);
    if (!source.dims && (!source.spacing || source.finerIfSmall))  // what was chosen
      scenario.organs[i].source.spacing = organ.rest.lattice.spacing.x();
    organ.map = vesselsOf(source, place, surface, readModel, notes);
    if (hasWays(scenario))
      placeWays(scenario, i,
                {surface.triangles.empty() ? organ.surface.mesh() : std::move(surface),
                 organ.rest.landmarks, organ.rest.lattice.spacing});
    std::unique_ptr<TissueModel> tissue = doubting(source, particleBox(organ.rest), [&] {
      return makeTissue(scenario.organs[i].tissue, organ, notes);
    });
    organs.push_back(operatedOrgan(source.name, std::move(organ), std::move(tissue)));
  }
  return organs;
}

std::vector<TissueJoint> makeJoints(const Scenario& scenario,
                                    const std::vector<OperatedOrgan>& organs) {
  std::vector<TissueJoint> joints;
  if (scenario.mode == OperationMode::Thesis) return joints;
  double shortest = 1;  // s: of the substeps
  for (std::size_t i = 0; i < organs.size(); ++i)
    if (const auto* elastic = dynamic_cast<const ElasticTissue*>(organs[i].tissue.get()))
      shortest = std::min(shortest, elastic->longestSubstep());
  for (const OrganJoint& joint : scenario.joints) {
    JoinedOrgan ends[2];
    for (int end = 0; end < 2; ++end) {
      const auto at = std::ranges::find(organs, joint.organs[end], &OperatedOrgan::name);
      require(at != organs.end(),
              "a joint names organ \"{}\", which does not exist; name one that does",
              joint.organs[end]);
      ends[end] = {std::int32_t(at - organs.begin()), &at->organ.rest.lattice, at->tissue.get()};
    }
    const auto springs = joinNear(ends[0], ends[1], joint.reach, joint.stiffness, shortest);
    if (springs.empty())
      throw error(
          "no particle of \"{}\" lies within {:.3g} mm of \"{}\"; give their joint a longer reach",
          joint.organs[0], 1e3 * joint.reach, joint.organs[1]);
    joints.insert(joints.end(), springs.begin(), springs.end());
  }
  return joints;
}

Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools,
                    Surroundings surroundings) {
  for (std::size_t i = 0; i < organs.size() && i < scenario.organs.size(); ++i)
    makeWounds(scenario.organs[i].source.wounds, organs[i]);
  Simulation simulation(std::move(organs), std::move(tools), std::move(joints), scenario.table);
  simulation.setBreathing(scenario.breathing);
  simulation.surround(std::move(surroundings));
  return simulation;
}

Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools,
                    std::vector<std::string>* notes) {
  Surroundings surroundings = surroundingsOf(scenario, organs, notes);
  return assemble(scenario, std::move(organs), std::move(joints), std::move(tools),
                  std::move(surroundings));
}

void noteSlowFrames(const Simulation& simulation, const Scenario& scenario,
                    std::vector<std::string>* notes) {
  const std::string note = slowFrameNote(simulation, 1 / scenario.frameRate);
  if (notes && !note.empty()) notes->push_back(note);
}

Simulation makeSimulation(Scenario& scenario, const ModelReader& readModel,
                          const Progress& progress, std::vector<std::string>* notes) {
  const bool chosen = std::ranges::any_of(scenario.organs, [](const ScenarioOrgan& organ) {
    return !organ.source.spacing && !organ.source.dims;
  });
  std::vector<OperatedOrgan> organs = loadOrgans(scenario, readModel, progress, notes);
  std::vector<TissueJoint> joints = makeJoints(scenario, organs);
  Simulation simulation = assemble(scenario, std::move(organs), std::move(joints),
                                   loadTools(scenario, readModel), notes);
  noteSlowFrames(simulation, scenario, notes);
  if (chosen && notes && simulation.moves())
    notes->push_back(paceNote(simulation, 1 / scenario.frameRate));
  settleWays(scenario, simulation);
  return simulation;
}

}  // namespace resect
