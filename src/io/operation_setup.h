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

// Function that reads any model file. It comes from a layer that knows all formats. An example is
// readModel() in inventor/reading/model_file.h. `parts`: the names of the needed parts, one per
// line; empty: all parts. The function may ignore `parts`, or return the needed parts joined to one
// part whose name is `parts`.
using ModelReader = std::function<Model(const std::filesystem::path&, const std::string& parts)>;

// The organ's closed surface, oriented outwards, in the world. It is placed in four steps:
// 1. It is rotated by source.pose.rotation.
// 2. If source.onTable and source.settle, it is rolled to a pose in which it lies still.
// 3. If source.onTable, it is moved so that its lowest point has y = 0 and its bounding box is
//    centred over the origin.
// 4. It is moved by source.pose.position.
// `place` may be null. If *place holds a pose, that pose is used instead of the four steps. If
// *place is empty, it receives the pose that results from the four steps. `notes` gets a sentence
// for each repair or doubt.
TriangleMesh loadOrganMesh(const OrganSource& source, const ModelReader& readModel,
                           std::vector<std::string>* notes = nullptr,
                           std::optional<Pose>* place = nullptr);

// The organ's cells, with the labels of the source. There are two kinds of source:
// - A model file or a built-in organ. The cells are sampled from the mesh of loadOrganMesh().
// - A file of particles (io/cells/particle_file.h), which contains cells. If source.resample, new
//   cells are sampled from the surface of these cells and replace them. The organ is not rotated,
//   and `place` is not used. Only steps 3 and 4 of loadOrganMesh() are applied, with the box of the
//   file's lattice.
// If cells are sampled and the source has neither spacing nor dims, a spacing is chosen
// (collision/coarsest_cell.h), and a note tells this spacing. `surface` may be null. Otherwise
// *surface receives the surface from which the cells were sampled. *surface becomes empty if the
// cells are taken from a file of particles without sampling. If tissue is thinner than two cells,
// `notes` says so (collision/wall_thickness.h). Throws Error if there is no particle, that is, no
// cell whose centre is inside the tissue. Also throws Error if a label marks no particle, or if the
// cells are so large that half of the tissue would be lost.
Discretization loadCells(const OrganSource& source, const ModelReader& readModel,
                         const Progress& progress = {}, std::vector<std::string>* notes = nullptr,
                         std::optional<Pose>* place = nullptr, TriangleMesh* surface = nullptr);

// A tool from its description file. name: the file's path, or the name of a tool that comes with
// Resect ("scalpel"). The tool is drawn as the parts of its model (io/drawn_parts.h).
ToolModel loadTool(const std::string& name, const ModelReader& readModel);

// The scenario's tools.
std::vector<std::unique_ptr<Tool>> loadTools(const Scenario& scenario,
                                             const ModelReader& readModel);

// The tissue of one organ, at rest. An attachment is a region in which the organ is held. Throws
// Error if an attachment of elastic tissue contains no particle, if a material is given for a label
// that no particle has, or if a setting is out of range. But an attachment whose region is given in
// fractions of the organ's box is left out with a note if it contains no particle, since it may
// have been made for an organ of another shape.
std::unique_ptr<TissueModel> makeTissue(const TissueSetup& setup, const Organ& organ,
                                        std::vector<std::string>* notes = nullptr);

// All organs of the scenario, at rest. The motion of a tool may be given in an organ's own
// coordinates. Such a motion is converted to keys in world coordinates
// (operation/way/place_ways.h), which are stored in `scenario`.
std::vector<OperatedOrgan> loadOrgans(Scenario& scenario, const ModelReader& readModel,
                                      const Progress& progress = {},
                                      std::vector<std::string>* notes = nullptr);
// The springs of all joints of the scenario. A joint connects two organs by springs. In thesis
// mode, in which instruments only remove tissue, there are no springs. Throws Error if a joint
// names an organ that does not exist, or if no two cells are near enough to be joined.
std::vector<TissueJoint> makeJoints(const Scenario& scenario,
                                    const std::vector<OperatedOrgan>& organs);

// Makes a simulation of organs, joints and tools. The wounds that exist at the start, the table and
// the breathing come from the scenario. surroundings: the bodies that stand round the organs.
Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools,
                    Surroundings surroundings);
// The same with the scenario's own surroundings (io/surroundings/surroundings_of.h).
Simulation assemble(const Scenario& scenario, std::vector<OperatedOrgan> organs,
                    std::vector<TissueJoint> joints, std::vector<std::unique_ptr<Tool>> tools,
                    std::vector<std::string>* notes = nullptr);

// Adds a note if the computation of a frame is expected to take longer than kSlowFrame
// (operation/frame_estimate.h).
void noteSlowFrames(const Simulation& simulation, const Scenario& scenario,
                    std::vector<std::string>* notes);

// Makes the whole simulation of a scenario by the functions above. Afterwards the simulation is
// ready for its first frame, and the scenario can be given to frameInput() (operation/scenario.h).
Simulation makeSimulation(Scenario& scenario, const ModelReader& readModel,
                          const Progress& progress = {}, std::vector<std::string>* notes = nullptr);

}  // namespace resect
