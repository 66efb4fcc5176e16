// Meshes of bare vessels and of clips, for viewers. A vessel is bare where the tissue round it has
// been removed.
#pragma once

#include <memory>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "simulation/simulation.h"
#include "surface/surface_update.h"

namespace resect {

struct BareVessels {
  // Walls of the bare vessels. The cut share, a number per vertex, says what the vertex shows
  // (vessel_walls.h). clipNormals: one per point of the clips. The rest positions in `walls` are in
  // rest space; all other coordinates are in the world. Unit: m.
  SurfaceCopy walls;
  TriangleMesh clips;
  std::vector<Vec3f> clipNormals;
  Aabb box;  // round all these meshes
};

// Null if there are no bare vessels and no clips. The ends of the walls lie inside tissue, which
// hides them. Cost: proportional to the number of bare segments and clips.
std::shared_ptr<const BareVessels> bareVessels(const Simulation& simulation);

}  // namespace resect
