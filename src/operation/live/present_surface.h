// The present surface of an organ.
#pragma once

#include <span>

#include "simulation/simulation.h"

namespace resect {

// View of an organ's surface after a step: the tracker's arrays, moved with the tissue. Valid until
// the next step.
struct PresentSurface {
  const Organ& organ;
  std::span<const Vec3f> points, normals;  // world, m; unit, outwards; one per vertex
  bool moves = false;                      // the tissue is elastic
};

// simulation.keepLook() must have been called: the view has normals.
inline PresentSurface presentSurface(const Simulation& simulation, std::size_t organ = 0) {
  const OperatedOrgan& o = simulation.organs()[organ];
  return {o.organ, o.points(), o.normals(), o.tissue->moves()};
}

}  // namespace resect
