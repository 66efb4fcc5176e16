// Obstacles: rigid bodies that tissue cannot enter. These are instruments, the table, the walls of
// the tool box, and the patient's body round the operative field.
#pragma once

#include <limits>
#include <span>

#include "collision/signed_distance.h"
#include "geometry/pose.h"
#include "tissue/cutting_edge.h"

namespace resect {

// An obstacle's motion and properties in one frame.
struct Obstacle {
  std::int32_t tool = -1;                 // number of the instrument; -1: not an instrument
  const SignedDistance* shape = nullptr;  // in the obstacle's coordinates; null: see halfSpace
  // Used only if `shape` is null. If true, the obstacle is the half space below y = 0 in its own
  // coordinates. If false, the obstacle has no extent, and tissue never touches it.
  bool halfSpace = false;
  Pose from, to;  // in the world, at the start and at the end of the frame
  // True for instruments with blades, jaws or hooks, which must be able to enter tissue. Then only
  // cell centres, but not the tissue's surface, are kept out of the obstacle.
  bool enters = false;
  double friction = 0.3;  // Coulomb's coefficient
  double slipForce = 0;   // force at which a tool releases all cells that it grips, N; 0: never
  std::span<const CuttingEdge> edges{};  // cutting edges of the instrument; empty: it does not cut
  // For a half space: distance of its borders from its origin along x (halfWidth) and along z
  // (halfDepth), m. If both are finite, the obstacle is a block without a bottom.
  double halfWidth = kEndless, halfDepth = kEndless;
  static constexpr double kEndless = std::numeric_limits<double>::infinity();
};

// The table's top, which lies at y = 0 if it is not displaced. from, to: the displacement at the
// start and at the end of the frame, m.
inline Obstacle tableTop(const Vec3& from = Vec3::Zero(), const Vec3& to = Vec3::Zero()) {
  Obstacle table;
  table.halfSpace = true;
  table.from.position = from;
  table.to.position = to;
  return table;
}

// An obstacle that does not move, such as the walls of the tool box.
inline Obstacle standing(const SignedDistance& shape, const Pose& pose) {
  Obstacle body;
  body.shape = &shape;
  body.from = body.to = pose;
  return body;
}

}  // namespace resect
