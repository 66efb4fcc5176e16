// Adds structures, such as tumours, cavities and vessels, to an organ. A scenario gives them as
// regions of the organ or as files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/vessel_map.h"
#include "io/operation_setup.h"

namespace resect {

// Adds the surfaces of the source's cavities to the organ's surface, with triangles that face into
// the cavities. The result bounds the part of the organ that is outside all cavities. A cavity may
// extend beyond the organ: no tissue is made outside the organ. All surfaces have the coordinates
// of the files, in metres. `notes` gets a sentence for each cavity. Throws Error if a cavity and
// the organ have no volume in common.
TriangleMesh hollowed(TriangleMesh organ, const OrganSource& source, const ModelReader& readModel,
                      std::vector<std::string>* notes);

// A sentence for people, or "". There is a sentence if all parts of the model become the organ's
// own tissue, but some parts have names of structures, such as tumours. The sentence then says by
// which options these parts get their roles.
std::string namedStructuresNote(const Model& model, const OrganSource& source);

// Adds the source's landmarks to `cells`. Then gives the cells their labels: a label is the number
// of the structure to which a cell belongs. The source gives each structure as a region of the
// organ or as a file. place: pose of the organ's file in the world; empty if this file is a file of
// particles. `notes` gets a sentence for each structure that marks so few particles that they
// hardly show its shape. Throws Error if a label or structure marks no particle, or if a structure
// has a file and `place` is empty.
void addLabels(Discretization& cells, const OrganSource& source, const std::optional<Pose>& place,
               const ModelReader& readModel, std::vector<std::string>* notes);

// The organ's vessels, in the world; null if there are no vessels. They come from the source's file
// of vessels, from its file of cells or from the built-in organ. The source may also give vessels
// as model files (OrganSource::structures). The centre lines of such vessels replace the vessels of
// the same kind. If source.smallVessels is set and the model files give both the portal vein and
// hepatic veins, vessels grow: smaller vessels from these veins into the rest of the organ, and an
// artery and a bile duct beside the portal vein. surface: closed surface of the organ in the world.
// For a file of particles it is empty, and no vessels grow. `notes` gets sentences for people.
std::shared_ptr<const VesselMap> vesselsOf(const OrganSource& source,
                                           const std::optional<Pose>& place,
                                           const TriangleMesh& surface,
                                           const ModelReader& readModel,
                                           std::vector<std::string>* notes);

// The translation that places a body with this bounding box, m. If source.onTable, it puts the body
// on the table: the lowest point is on the table's top, and the box is centred over the origin. In
// any case source.pose.position is added.
Vec3 placedBy(const OrganSource& source, const Aabb& box);

// A box as text, for messages about regions.
std::string boxText(const Aabb& box);

}  // namespace resect
