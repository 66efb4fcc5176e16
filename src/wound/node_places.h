// Present positions of grid nodes in tissue that has moved.
//
// Blades are tested against the moved tissue (wound/blade_raster.h). So before edges are severed,
// the nodes near the blade are moved. A node inside tissue follows particles as a vertex of the
// surface does (wound/vertex_binding.h). A node outside tissue follows all particles among the
// eight cells whose centres surround it. If no particle is found, the node has no position. The
// cost is proportional to the number of nodes, plus a pass over the box round all of them.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "wound/particle_motion.h"
#include "wound/wound_brick.h"

namespace resect {

// The bindings of grid nodes, in the order of `nodes`. If no particle is found for a node, its
// VertexBinding::count is 0.
std::vector<VertexBinding> bindNodes(const ColourField& field, const Wound& wound, float iso,
                                     std::span<const Vec3i> nodes);

// The positions of grid nodes (world, m), in the order of `nodes`. NaN for a node for which no
// particle is found. motionOf(cell): the ParticleMotion of the particle with that lattice index.
template <typename MotionOf>
std::vector<Vec3> placeNodes(const ColourField& field, const Wound& wound, float iso,
                             std::span<const Vec3i> nodes, const MotionOf& motionOf) {
  const std::vector<VertexBinding> bindings = bindNodes(field, wound, iso, nodes);
  std::vector<Vec3> places(nodes.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const VertexBinding& binding = bindings[n];
    if (binding.count == 0) continue;
    ParticleMotion mean;
    for (std::size_t i = 0; i < std::size_t(binding.count); ++i)
      add(mean, binding.weight[i], motionOf(binding.cell[i]));
    const Vec3 X = field.nodePosition(nodes[n].cast<double>());
    const Column moved = displacementAt(mean, X.cast<float>());
    places[n] = X + Vec3(moved[0], moved[1], moved[2]);
  }
  return places;
}

}  // namespace resect
