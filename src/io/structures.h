// Structures inside an organ: labels of its cells, and its vessels, from regions and files that a
// scenario names.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/vessel_map.h"
#include "io/operation_setup.h"

namespace resect {

// The organ's surface with that of the source's cavities, whose triangles face into the cavities:
// no tissue lies in a cavity, also where it reaches out of the organ. All in the coordinates of the
// files, m. `notes` gets a sentence for each cavity. Throws Error if a cavity and the organ have no
// tissue in common, or if the cavity leaves none.
TriangleMesh hollowed(TriangleMesh organ, const OrganSource& source, const ModelReader& readModel,
                      std::vector<std::string>* notes);

// Adds the source's landmarks, labels and structures to the cells. place: of the organ's file in
// the room; empty for a file of particles. Throws Error if one of them marks no particle, or if a
// structure's file is needed and has no place.
void addLabels(Discretization& cells, const OrganSource& source, const std::optional<Pose>& place,
               const ModelReader& readModel);

// The organ's vessels where it lies: those of the source's file of vessels, of its file of cells,
// or of the built-in organ, and the centre lines of vessels that the source brings as model files.
// A kind that is brought replaces that kind. Where portal vein and hepatic veins are brought,
// smaller vessels grow from them into the rest of the organ, and artery and duct beside the portal
// vein, if source.smallVessels. surface: of the organ where it lies, closed; empty for a file of
// particles, where none grow. Null if there are no vessels. `notes` gets sentences for people.
std::shared_ptr<const VesselMap> vesselsOf(const OrganSource& source,
                                           const std::optional<Pose>& place,
                                           const TriangleMesh& surface,
                                           const ModelReader& readModel,
                                           std::vector<std::string>* notes);

// Translation of a body whose box is `box`: onto the table, centred over the origin with its lowest
// point on the top, if source.onTable; then by the source's position.
Vec3 placedBy(const OrganSource& source, const Aabb& box);

// A box as text, for messages about regions.
std::string boxText(const Aabb& box);

}  // namespace resect
