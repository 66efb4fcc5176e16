// Obstacles: rigid bodies that tissue cannot enter: instruments, the table, the tray.
#pragma once

#include "collision/signed_distance.h"
#include "geometry/pose.h"

namespace resect {

// An obstacle's motion and properties in one frame.
struct Obstacle {
  std::int32_t tool = -1;                 // number of the instrument; -1: not an instrument
  const SignedDistance* shape = nullptr;  // in its frame; null: see halfSpace
  bool halfSpace =
      false;      // without a shape: everything below y = 0 of its frame if true, else nothing
  Pose from, to;  // at the start and the end of the frame
  double standOff = 0;  // cells' centres are kept this far from its surface, m
  double friction = 0.3;
  double slipForce = 0;  // of an instrument's grip, N: beyond it the grip releases all cells
};

// A level top at y = 0. spacing: of the cells that will rest on it, m.
inline Obstacle tableTop(double spacing) {
  Obstacle table;
  table.halfSpace = true;
  table.standOff = 0.5 * spacing;
  return table;
}

// A body that stands still, such as the tray.
inline Obstacle standing(const SignedDistance& shape, const Pose& pose, double spacing) {
  Obstacle body;
  body.shape = &shape;
  body.from = body.to = pose;
  body.standOff = 0.5 * spacing;
  return body;
}

}  // namespace resect
