// Where is an organ's surface at this moment?
#pragma once

#include <span>

#include "simulation/simulation.h"

namespace resect {

// What is seen of one organ after a step; good until the next. Its tracker's arrays, moved with the
// tissue.
struct PresentSurface {
  const Organ& organ;
  std::span<const Vec3f> points, normals;  // world, m; unit, outwards; one per vertex
  bool moves = false;                      // the tissue is elastic
};

// Of a simulation that keeps its look.
inline PresentSurface presentSurface(const Simulation& simulation, std::size_t organ = 0) {
  const OperatedOrgan& o = simulation.organs()[organ];
  return {o.organ, o.points(), o.normals(), o.tissue->moves()};
}

}  // namespace resect
