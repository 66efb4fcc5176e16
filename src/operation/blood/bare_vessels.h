// Vessels that no tissue covers, and clips, for viewers.
#pragma once

#include <array>
#include <memory>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"
#include "simulation/simulation.h"

namespace resect {

struct BareVessels {
  // Tubes of each kind, sealed places, and clips; world, m.
  std::array<TriangleMesh, kVesselKinds> tubes;
  TriangleMesh sealed, clips;
  Aabb box;  // round all of them
};

// Null if there are none. Tubes run on into the tissue, which hides them. Cost: the bared segments
// and the clips.
std::shared_ptr<const BareVessels> bareVessels(const Simulation& simulation);

}  // namespace resect
