// The surface of an organ in its present position.
#pragma once

#include <span>

#include "simulation/simulation.h"

namespace resect {

// View of an organ's surface after a step. It has the arrays of Organ::surface, but points and
// normals have moved with the tissue. Valid until the next step.
struct PresentSurface {
  const Organ& organ;
  // One point and one normal per vertex. Points: world, m. Normals: unit, outwards.
  std::span<const Vec3f> points, normals;
  bool moves = false;  // TissueModel::moves()
  const OperatedOrgan* operated = nullptr;
  const BloodFilm* film = nullptr;  // null: the organ does not bleed
};

// The view of an organ's present surface. organ: the organ's number. simulation.keepLook() must
// have been called before the step, since the view has normals.
inline PresentSurface presentSurface(const Simulation& simulation, std::size_t organ = 0) {
  const OperatedOrgan& o = simulation.organs()[organ];
  return {o.organ,           o.points(), o.normals(),
          o.tissue->moves(), &o,         o.organ.map ? &simulation.blood().film(organ) : nullptr};
}

}  // namespace resect
