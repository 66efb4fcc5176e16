// Cutting edges of instruments, and the cuts that they make.
#pragma once

#include <cstdint>
#include <span>

#include "collision/swept_blade.h"
#include "geometry/pose.h"

namespace resect {

// An edge and its motion in one frame. The edge cuts in the direction `tangent x normal`; the
// tangent points from the edge's first point to its last.
struct CuttingEdge {
  std::span<const Vec3> points;  // corners of the edge, m, in its own coordinates; at least two
  Vec3 normal;                   // of the blade's plane, unit, in the same coordinates
  Pose from, to;                 // of these coordinates in the world, at the frame's start and end
  double bluntness = 1;          // factor on the energy that a cut needs, 0 or more
  // Whether the points are taken in reverse order, so that the cuts of two edges that meet have
  // normals on the same side.
  bool reversed = false;
  // False: the edge begins no new cut, as with jaws that are not closing. It may continue a cut in
  // elastic tissue; still tissue is not cut at all.
  bool begins = true;
};

// Whether the edge's motion can cut: the middle of the edge moves more in the plane of the blade
// than across it, and in that plane less than 120 degrees away from the direction of the cut. So
// the edge may slide along itself, but not move sideways or back out of a cut.
bool movesToCut(const CuttingEdge& edge);

// A cut that an edge made in one frame.
struct TissueCut {
  std::int32_t tool = -1;
  SweptBlade blade;  // in rest space, m
};

}  // namespace resect
