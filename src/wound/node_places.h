// Where are the nodes of the grid now that the tissue has moved?
//
// A blade meets tissue where it is, not where it was at rest: before edges are severed
// (wound/blade_raster.h), the nodes near the blade follow their particles as the surface's
// vertices do (wound/vertex_binding.h). A node outside tissue follows all particles of its
// lattice cube; one with none has no place. Cost: in proportion to the nodes, and a pass over the
// box round all of them.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "wound/particle_motion.h"
#include "wound/wound_brick.h"

namespace resect {

// What each of some nodes of the grid follows, in their order; count 0 where nothing is near.
std::vector<VertexBinding> bindNodes(const ColourField& field, const Wound& wound, float iso,
                                     std::span<const Vec3i> nodes);

// The places of some nodes (world, m), in their order; NaN for those that follow nothing.
// motionOf(cell) gives the motion of a particle by its lattice index.
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
