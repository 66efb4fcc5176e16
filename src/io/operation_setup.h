// Makes a simulation from a scenario: reads the files that it names and builds organs, tissue and
// tools.
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

// The organ's closed, outward surface where the scenario puts it: turned by source.pose, then laid
// on the table (lowest point at y = 0, bounding box centred over the origin) when source.onTable,
// then moved by the pose's position. `place`, if given: if set, the pose to use instead; else it
// receives the pose used. `notes` gets a sentence for each repair or finding.
TriangleMesh loadOrganMesh(const OrganSource& source, const ModelReader& readModel,
                           std::vector<std::string>* notes = nullptr,
                           std::optional<Pose>* place = nullptr);

// The organ's cells: from a file of particles (io/cells/particle_file.h, taken where its
// coordinates put it unless onTable, and with its own cells unless source.resample), else from the
// mesh; with the labels of the source. Throws Error if one of them marks no particle.
Discretization loadCells(const OrganSource& source, const ModelReader& readModel,
                         const Progress& progress = {}, std::vector<std::string>* notes = nullptr,
                         std::optional<Pose>* place = nullptr);

// The scenario's tools, from their description files (given as files, or by shipped name:
// "scalpel").
std::vector<std::unique_ptr<Tool>> loadTools(const Scenario& scenario,
                                             const ModelReader& readModel);

// The tissue that the scenario asks for, at rest. Throws Error if an attachment contains no
// particle, a material is for a label without particles, or a setting is out of range.
std::unique_ptr<TissueModel> makeTissue(const TissueSetup& setup, const Organ& organ);

// All organs of the scenario at rest, and the springs between them. Throws Error if a joint
// connects no cells.
std::vector<OperatedOrgan> loadOrgans(const Scenario& scenario, const ModelReader& readModel,
                                      const Progress& progress = {},
                                      std::vector<std::string>* notes = nullptr);
std::vector<TissueJoint> makeJoints(const Scenario& scenario,
                                    const std::vector<OperatedOrgan>& organs);

// Organs, their joints and tools in the scenario's room: on its table, beside its tray. A tray that
// an organ lies in from the start does not push it out.
Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools);

// All of the above: the scenario, ready for its first frame.
Simulation makeSimulation(const Scenario& scenario, const ModelReader& readModel,
                          const Progress& progress = {}, std::vector<std::string>* notes = nullptr);

}  // namespace resect
