#include "io/operation_setup.h"

#include "base/error.h"
#include "geometry/resting_pose.h"
#include "io/data_folder.h"
#include "io/discretization_file.h"
#include "io/organ_mesh.h"
#include "io/scenario_file.h"
#include "organ/builtin_gallbladder.h"
#include "organ/builtin_liver.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "tissue/still_tissue.h"
#include "tools/registry.h"

namespace resect {
namespace {

// What lays a box on the table: centred over the origin, lowest point on the table top.
Vec3 ontoTable(const Aabb& box) { return {-box.centre().x(), -box.min.y(), -box.centre().z()}; }

// The cells that the source asks for, of a closed surface.
Discretization sample(const TriangleMesh& surface, const OrganSource& source,
                      const Progress& progress) {
  const Aabb box = bounds(surface);
  Discretization cells = discretize(
      surface,
      source.dims ? latticeForDims(box, *source.dims) : latticeForSpacing(box, *source.spacing),
      progress);
  fitSurface(surface, cells);
  return cells;
}

}  // namespace

TriangleMesh loadOrganMesh(const OrganSource& source, const ModelReader& readModel,
                           std::vector<std::string>* notes) {
  TriangleMesh mesh;
  if (source.file.empty()) {
    mesh = builtinLiver();
  } else if (source.file == "gallbladder") {
    mesh = builtinGallbladder();
  } else {
    const OrganMesh organ =
        prepareOrganMesh(readModel(source.file), {source.part, source.repair, source.unit});
    mesh = organ.mesh;
    if (notes) notes->insert(notes->end(), organ.notes.begin(), organ.notes.end());
  }
  mesh = transformed(std::move(mesh), {Vec3::Zero(), source.pose.rotation});
  if (source.onTable && source.settle)
    mesh = transformed(mesh, {Vec3::Zero(), restingRotation(mesh)});
  const Vec3 shift =
      (source.onTable ? ontoTable(bounds(mesh)) : Vec3(Vec3::Zero())) + source.pose.position;
  return transformed(std::move(mesh), {shift, Eigen::Quaterniond::Identity()});
}

Discretization loadCells(const OrganSource& source, const ModelReader& readModel,
                         const Progress& progress, std::vector<std::string>* notes) {
  if (!isDiscretizationFile(source.file))
    return sample(loadOrganMesh(source, readModel, notes), source, progress);
  if (!source.part.empty() || source.repair)
    throw usageError("{} holds particles: it has no parts and needs no repair; leave {} out",
                     source.file, source.repair ? "--repair" : "--part");
  Discretization cells = readDiscretization(source.file, source.unit);
  cells.lattice.origin +=
      source.pose.position + (source.onTable ? ontoTable(cells.lattice.box()) : Vec3(Vec3::Zero()));
  if (!source.resample) return cells;
  const std::int64_t before = cells.particleCount();
  const TriangleMesh surface = makeOrgan(std::move(cells), {}).surface.mesh();
  if (surface.triangles.empty())
    throw error("{} has no surface to sample anew; make it from a mesh", source.file);
  if (notes) notes->push_back(fmt::format("sampled anew from the surface of {} particles", before));
  return sample(surface, source, progress);
}

std::vector<std::unique_ptr<Tool>> loadTools(const Scenario& scenario,
                                             const ModelReader& readModel) {
  const auto readMesh = [&](const std::filesystem::path& path) {
    return prepareOrganMesh(readModel(path), {}).mesh;
  };
  std::vector<std::unique_ptr<Tool>> tools;
  for (const ScenarioTool& tool : scenario.tools) {
    ToolModel model = readTool(findDataFile(tool.model, "tools", ".toml"), readMesh);
    if (tool.response) model.response = *tool.response;
    if (scenario.mode == OperationMode::Thesis) model.response = "remove";
    tools.push_back(makeTool(std::move(model)));
  }
  return tools;
}

std::unique_ptr<TissueModel> makeTissue(const TissueSetup& setup, const Organ& organ) {
  if (!setup.elastic) return std::make_unique<StillTissue>(organ.rest.lattice, organ.alive);
  auto tissue = std::make_unique<ElasticTissue>(
      TissueCells{organ.rest.lattice, organ.rest.inside, {setup.material}, {}}, setup.settings);
  for (std::size_t i = 0; i < setup.attachments.size(); ++i)
    if (tissue->attach(setup.attachments[i]) == 0)
      throw error(
          "attachment {} of the tissue holds no particle; move or enlarge its region (world "
          "coordinates of the organ at rest, m)",
          i + 1);
  return tissue;
}

Simulation makeSimulation(const Scenario& scenario, const ModelReader& readModel,
                          const Progress& progress, std::vector<std::string>* notes) {
  Organ organ =
      makeOrgan(loadCells(scenario.organ, readModel, progress, notes), scenario.organ.settings);
  std::unique_ptr<TissueModel> tissue = makeTissue(scenario.tissue, organ);
  return Simulation(std::move(organ), loadTools(scenario, readModel), std::move(tissue),
                    scenario.table);
}

}  // namespace resect
