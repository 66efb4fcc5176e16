// Cutting edges of instruments, and what they cut.
#pragma once

#include <cstdint>
#include <span>

#include "collision/swept_blade.h"
#include "geometry/pose.h"

namespace resect {

// An edge and its motion in one frame. It cuts towards `tangent x normal`, where the tangent leads
// from its first point to its last.
struct CuttingEdge {
  std::span<const Vec3> points;  // corners of the edge, m, in its own coordinates; at least two
  Vec3 normal;                   // of the blade's plane, unit, in the same coordinates
  Pose from, to;                 // world, at the start and at the end of the frame
  double bluntness = 1;          // factor on the energy that a cut takes, 0 or more
  // Whether the points are taken in reverse order, so that the cuts of two edges that meet have
  // normals on the same side.
  bool reversed = false;
  // False: the edge goes on with the cut that it is in, but begins no other, as jaws that do not
  // close.
  bool begins = true;
};

// Whether the edge moves forwards in the plane of its blade, or along itself: neither sideways nor
// back out of a cut. By the middle of the edge.
bool movesToCut(const CuttingEdge& edge);

// A cut that an edge made in one frame.
struct TissueCut {
  std::int32_t tool = -1;
  SweptBlade blade;  // in the tissue at rest, m
};

}  // namespace resect
