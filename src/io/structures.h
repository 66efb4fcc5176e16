// Adds structures to an organ: labels of its cells, and vessels, from the regions and files that a
// scenario gives.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/vessel_map.h"
#include "io/operation_setup.h"

namespace resect {

// Adds the surfaces of the source's cavities to the organ's surface, with triangles that face into
// the cavities. So a cavity contains no tissue, also where it extends beyond the organ. All
// coordinates are those of the files, m. `notes` gets a sentence for each cavity. Throws Error if a
// cavity and the organ have no volume in common.
TriangleMesh hollowed(TriangleMesh organ, const OrganSource& source, const ModelReader& readModel,
                      std::vector<std::string>* notes);

// A sentence for people if all parts of the model become the organ's body although some have names
// of structures: it says how these get their roles. Otherwise "".
std::string namedStructuresNote(const Model& model, const OrganSource& source);

// Adds the source's landmarks, labels and structures to the cells. place: pose of the organ's file
// in the world; empty for a file of particles. `notes` gets a sentence for each structure that
// marks so few particles that they hardly show its shape. Throws Error if a label or structure
// marks no particle, or if a structure has a file and `place` is empty.
void addLabels(Discretization& cells, const OrganSource& source, const std::optional<Pose>& place,
               const ModelReader& readModel, std::vector<std::string>* notes);

// The organ's vessels, in the world. They come from the source's file of vessels, from its file of
// cells or from the built-in organ. Vessels that the source gives as model files
// (OrganSource::structures) replace those of the same kind, by their centre lines. If these files
// give both portal vein and hepatic veins, and source.smallVessels is set, smaller vessels grow
// from them into the rest of the organ, and an artery and a bile duct grow beside the portal vein.
// surface: closed surface of the organ in the world; empty for a file of particles, for which no
// vessels grow. Null if there are no vessels. `notes` gets sentences for people.
std::shared_ptr<const VesselMap> vesselsOf(const OrganSource& source,
                                           const std::optional<Pose>& place,
                                           const TriangleMesh& surface,
                                           const ModelReader& readModel,
                                           std::vector<std::string>* notes);

// The translation by which a body with this box, m, is placed: if source.onTable, onto the table,
// with its lowest point on the table's top and centred over the origin; then by
// source.pose.position.
Vec3 placedBy(const OrganSource& source, const Aabb& box);

// A box as text, for messages about regions.
std::string boxText(const Aabb& box);

}  // namespace resect
