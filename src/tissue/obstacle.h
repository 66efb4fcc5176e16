// Obstacles are rigid bodies that tissue cannot enter: instruments, the table, the tray.
#pragma once

#include "collision/signed_distance.h"
#include "geometry/pose.h"

namespace resect {

// An obstacle's motion and properties in one frame.
struct Obstacle {
  std::int32_t tool = -1;                 // number of the instrument; -1: not an instrument
  const SignedDistance* shape = nullptr;  // in the obstacle's coordinates; null: see halfSpace
  // Used if there is no shape. True: the obstacle is the half space below y = 0 in its own
  // coordinates. False: the obstacle is nowhere.
  bool halfSpace = false;
  Pose from, to;          // at the start and the end of the frame
  double standOff = 0;    // cells' centres are kept this far from its surface, m
  double friction = 0.3;  // Coulomb's coefficient
  double slipForce = 0;   // N: beyond it an instrument's grip releases all cells; 0: never
};

// A level table top at y = 0. spacing: that of the tissue's lattice, m.
inline Obstacle tableTop(double spacing) {
  Obstacle table;
  table.halfSpace = true;
  table.standOff = 0.5 * spacing;
  return table;
}

// A body that stands still, such as the tray. spacing: as above.
inline Obstacle standing(const SignedDistance& shape, const Pose& pose, double spacing) {
  Obstacle body;
  body.shape = &shape;
  body.from = body.to = pose;
  body.standOff = 0.5 * spacing;
  return body;
}

}  // namespace resect
