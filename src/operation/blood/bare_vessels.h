// Meshes of bare vessels and of clips, for viewers.
#pragma once

#include <array>
#include <memory>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"
#include "simulation/simulation.h"

namespace resect {

struct BareVessels {
  // tubes: walls of the bare vessels, one mesh per VesselKind. mouths: lumens that are seen at cut
  // ends. sealed: the parts of vessels that heat has sealed. All coordinates are in the world, m.
  std::array<TriangleMesh, kVesselKinds> tubes;
  TriangleMesh mouths, sealed, clips;
  Aabb box;  // round all these meshes
};

// Null if there are no bare vessels and no clips. The ends of the tubes lie inside tissue, which
// hides them. Cost: proportional to the number of bare segments and clips.
std::shared_ptr<const BareVessels> bareVessels(const Simulation& simulation);

}  // namespace resect
