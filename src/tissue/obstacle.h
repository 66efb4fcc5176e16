// Obstacles: rigid bodies that tissue cannot enter. These are instruments, the table and the walls
// of the tool box.
#pragma once

#include <span>

#include "collision/signed_distance.h"
#include "geometry/pose.h"
#include "tissue/cutting_edge.h"

namespace resect {

// An obstacle's motion and properties in one frame.
struct Obstacle {
  std::int32_t tool = -1;                 // number of the instrument; -1: not an instrument
  const SignedDistance* shape = nullptr;  // in the obstacle's coordinates; null: see halfSpace
  // Used if `shape` is null. True: the obstacle is the half space below y = 0 in its own
  // coordinates. False: the obstacle has no extent, and tissue never touches it.
  bool halfSpace = false;
  Pose from, to;  // in the world, at the start and at the end of the frame
  // True for blades and hooks: only cell centres, not the tissue's surface, are kept out of it.
  bool enters = false;
  double friction = 0.3;  // Coulomb's coefficient
  double slipForce = 0;   // force at which an instrument releases all cells it grips, N; 0: never
  std::span<const CuttingEdge> edges{};  // cutting edges of the instrument; empty: it does not cut
};

// The table's top at y = 0.
inline Obstacle tableTop() {
  Obstacle table;
  table.halfSpace = true;
  return table;
}

// A body that stands still, such as the walls of the tool box.
inline Obstacle standing(const SignedDistance& shape, const Pose& pose) {
  Obstacle body;
  body.shape = &shape;
  body.from = body.to = pose;
  return body;
}

}  // namespace resect
