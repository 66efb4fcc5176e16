// Makes a simulation from a scenario: reads the files that the scenario names, and makes organs,
// tissue and tools from them.
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

// Function that reads any model file. It comes from a layer that knows all formats, such as
// readModel() in inventor/reading/model_file.h. `parts`: the names of the needed parts, one per
// line; empty: all parts. The function may ignore `parts`, or return the needed parts joined to one
// part whose name is `parts`.
using ModelReader = std::function<Model(const std::filesystem::path&, const std::string& parts)>;

// The organ's closed surface, oriented outwards, in the world. It is placed in four steps:
// 1. It is rotated by source.pose.rotation.
// 2. If source.onTable and source.settle, it is rolled to a pose in which it lies still.
// 3. If source.onTable, its lowest point gets y = 0 and its bounding box is centred over the
//    origin.
// 4. It is moved by source.pose.position.
// `place` may be null. If *place holds a pose, that pose is used instead of the four steps. If
// *place is empty, it receives the pose that results from the four steps. `notes` gets a sentence
// for each repair or finding.
TriangleMesh loadOrganMesh(const OrganSource& source, const ModelReader& readModel,
                           std::vector<std::string>* notes = nullptr,
                           std::optional<Pose>* place = nullptr);

// The organ's cells, with the labels of the source. The cells are sampled from the mesh of
// loadOrganMesh() unless the source is a file of particles (io/cells/particle_file.h). Such a file
// contains cells; if source.resample, new cells are sampled from their surface. With such a file
// the organ is not rotated and `place` is not used: only steps 3 and 4 of loadOrganMesh() are
// applied, with the box of the file's lattice. If the source has neither spacing nor dims, the
// spacing is chosen (collision/coarsest_cell.h), and a note gives it. `surface` may be null. It
// receives the surface from which the cells were sampled, or nothing if they come from a file.
// Walls that are thinner than two cells get a note (collision/wall_thickness.h). Throws Error if a
// label marks no particle, if there is no particle, or if the cells are so large that half of the
// tissue would be lost.
Discretization loadCells(const OrganSource& source, const ModelReader& readModel,
                         const Progress& progress = {}, std::vector<std::string>* notes = nullptr,
                         std::optional<Pose>* place = nullptr, TriangleMesh* surface = nullptr);

// A tool from its description file. name: the file's path, or the name of a tool that comes with
// Resect ("scalpel"). The tool is drawn as the parts of its model (io/drawn_parts.h).
ToolModel loadTool(const std::string& name, const ModelReader& readModel);

// The scenario's tools.
std::vector<std::unique_ptr<Tool>> loadTools(const Scenario& scenario,
                                             const ModelReader& readModel);

// The tissue of one organ, at rest. Throws Error if an attachment of elastic tissue contains no
// particle, if a material is for a label that no particle has, or if a setting is out of range. An
// attachment in fractions of the organ's box that contains no particle is left out with a note,
// since it may have been made for an organ of another shape.
std::unique_ptr<TissueModel> makeTissue(const TissueSetup& setup, const Organ& organ,
                                        std::vector<std::string>* notes = nullptr);

// All organs of the scenario, at rest. Ways of tools are converted to keys in the scenario
// (operation/way/place_ways.h).
std::vector<OperatedOrgan> loadOrgans(Scenario& scenario, const ModelReader& readModel,
                                      const Progress& progress = {},
                                      std::vector<std::string>* notes = nullptr);
// The springs of all joints of the scenario. In thesis mode there are none. Throws Error if a joint
// names an organ that does not exist, or if no two cells are near enough for it.
std::vector<TissueJoint> makeJoints(const Scenario& scenario,
                                    const std::vector<OperatedOrgan>& organs);

// Makes a simulation of organs, joints and tools, with the scenario's table. The walls of the
// scenario's tool box become an obstacle for moving tissue, unless a particle of some organ lies in
// the tool box at the start: the walls would push that organ out.
Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools);

// Adds a note if frames will take long (operation/frame_estimate.h).
void noteSlowFrames(const Simulation& simulation, const Scenario& scenario,
                    std::vector<std::string>* notes);

// Makes the whole simulation of a scenario by the functions above. The simulation is then ready for
// its first frame, and the scenario for frameInput().
Simulation makeSimulation(Scenario& scenario, const ModelReader& readModel,
                          const Progress& progress = {}, std::vector<std::string>* notes = nullptr);

}  // namespace resect
