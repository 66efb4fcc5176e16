// The surface of an organ in its present position.
#pragma once

#include <span>

#include "simulation/simulation.h"

namespace resect {

// View of an organ's surface after a step. Its arrays are those of Organ::surface, with the points
// and normals moved as the tissue has moved. Valid until the next step.
struct PresentSurface {
  const Organ& organ;
  std::span<const Vec3f> points, normals;  // world, m; unit, outwards; one per vertex
  bool moves = false;                      // TissueModel::moves()
  const OperatedOrgan* operated = nullptr;
  const BloodFilm* film = nullptr;  // null: the organ does not bleed
};

// organ: its number. Call simulation.keepLook() before the step, since the view has normals.
inline PresentSurface presentSurface(const Simulation& simulation, std::size_t organ = 0) {
  const OperatedOrgan& o = simulation.organs()[organ];
  return {o.organ,           o.points(), o.normals(),
          o.tissue->moves(), &o,         o.organ.map ? &simulation.blood().film(organ) : nullptr};
}

}  // namespace resect
