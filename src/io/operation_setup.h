// Makes a simulation from a scenario: reads the files that the scenario names and builds organs,
// tissue and tools.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "io/model.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

// Function that reads any model file; supplied by a layer that knows all formats
// (inventor/reading/model_file.h).
using ModelReader = std::function<Model(const std::filesystem::path&)>;

// The organ's closed surface, oriented outwards, in the world. The organ is rotated as source.pose
// says; if source.onTable, it is laid on the table (rolled to a resting pose if source.settle;
// lowest point at y = 0, bounding box centred over the origin); then it is moved by the pose's
// position. If `place` is given and holds a pose, that pose is used instead of all this; if `place`
// is given and empty, it receives the pose that was used. `notes` gets a sentence for each repair
// or finding.
TriangleMesh loadOrganMesh(const OrganSource& source, const ModelReader& readModel,
                           std::vector<std::string>* notes = nullptr,
                           std::optional<Pose>* place = nullptr);

// The organ's cells, with the labels of the source. A file of particles (io/cells/particle_file.h)
// keeps its cells unless source.resample, and lies where its coordinates put it, moved onto the
// table if source.onTable and then by the pose's position; it is neither rotated nor settled. Any
// other source is sampled from its mesh. Throws Error if a label marks no particle.
Discretization loadCells(const OrganSource& source, const ModelReader& readModel,
                         const Progress& progress = {}, std::vector<std::string>* notes = nullptr,
                         std::optional<Pose>* place = nullptr);

// The scenario's tools, from their description files. The scenario names each by its path or by a
// shipped name ("scalpel").
std::vector<std::unique_ptr<Tool>> loadTools(const Scenario& scenario,
                                             const ModelReader& readModel);

// The tissue that the scenario asks for, at rest. Throws Error if an attachment contains no
// particle, a material is for a label without particles, or a setting is out of range.
std::unique_ptr<TissueModel> makeTissue(const TissueSetup& setup, const Organ& organ);

// All organs of the scenario, at rest.
std::vector<OperatedOrgan> loadOrgans(const Scenario& scenario, const ModelReader& readModel,
                                      const Progress& progress = {},
                                      std::vector<std::string>* notes = nullptr);
// The springs of the scenario's joints; none in thesis mode. Throws Error if a joint connects no
// cells.
std::vector<TissueJoint> makeJoints(const Scenario& scenario,
                                    const std::vector<OperatedOrgan>& organs);

// Puts organs, joints and tools into the scenario's room: its table, and the walls of its tool box
// as an obstacle for moving tissue. If a particle lies in the tool box at the start, the box is no
// obstacle, so that it does not push the organ out.
Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools);

// Does all of the above: the result is ready for its first frame.
Simulation makeSimulation(const Scenario& scenario, const ModelReader& readModel,
                          const Progress& progress = {}, std::vector<std::string>* notes = nullptr);

}  // namespace resect
