// Cutting edges of instruments, and the cuts that they make.
#pragma once

#include <cstdint>
#include <span>

#include "collision/swept_blade.h"
#include "geometry/pose.h"

namespace resect {

// An edge, which is a polyline, and its motion in one frame. The edge cuts in the direction tangent
// x normal (cross product). The edge's tangent points from its first point to its last.
struct CuttingEdge {
  std::span<const Vec3> points;  // of the polyline, in the edge's coordinates, m; at least two
  Vec3 normal;                   // normal of the blade's plane, unit, in the same coordinates
  Pose from, to;                 // poses of the edge, world, at the frame's start and end
  double bluntness = 1;          // factor on the energy that a cut takes, 0 or more
  // Whether the surface of the cut is built with the points in reverse order. Scissors have two
  // edges, which both make cuts. For one of the edges `reversed` is true, so that the normals of
  // all these cuts point to the same side.
  bool reversed = false;
  // False if the edge begins no new cut, for example because the scissors are not closing. Such an
  // edge may continue a cut in elastic tissue. It does not cut tissue that never moves
  // (tissue/still_tissue.h).
  bool begins = true;
};

// Whether the edge's motion can cut. Two conditions must hold for the motion of the middle of the
// edge. First, the component of this motion in the blade's plane must be larger than the component
// normal to the plane. Second, the angle between the component in the plane and the direction in
// which the edge cuts must be less than 120 degrees. So an edge can cut while it slides along
// itself, but not while it moves sideways or back out of a cut.
bool movesToCut(const CuttingEdge& edge);

// A cut that an edge made in one frame.
struct TissueCut {
  std::int32_t tool = -1;
  SweptBlade blade;  // in rest space, m
};

}  // namespace resect
