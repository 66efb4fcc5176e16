// Welding: merges points at the same position, so that triangles share their points.
//
// The same result on every machine: points keep the order in which they first appear, triangles
// keep theirs. Equal points are found by a hash of the position, usually O(n); near ones by
// sorting.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct WeldReport {
  int mergedPoints = 0;         // points merged into another
  int unusedPoints = 0;         // points that no triangle used
  int degenerateTriangles = 0;  // triangles dropped because two of their corners became one
};

// Merges points of equal position and drops points without triangles and triangles with fewer than
// three different corners. A triangle whose three corners lie on one line stays: without it the
// surface would open along that line.
//
// relativeTolerance >= 0: points closer than this share of the bounding box's diagonal are equal
// too, and take the position of the first of them; 0 merges exact equals only. Chains of near
// points merge as a whole, so keep it far below the edge lengths (1e-6 bridges rounding).
// Positions must be finite.
TriangleMesh weld(const TriangleMesh& mesh, double relativeTolerance = 0,
                  WeldReport* report = nullptr);

}  // namespace resect
