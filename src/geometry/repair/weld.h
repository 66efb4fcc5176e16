// Welding: merges points at the same position, so that triangles that meet there share one point.
//
// The result is the same on every machine: points keep the order in which they first appear, and
// triangles keep their order. Points at equal positions are found by a hash, usually in O(n);
// points that are only near each other are found by sorting.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct WeldReport {
  int mergedPoints = 0;         // points merged into another
  int unusedPoints = 0;         // points dropped because no triangle uses them
  int degenerateTriangles = 0;  // triangles dropped because two of their corners are one point
};

// Merges points at equal positions. Drops triangles that then have fewer than three different
// corners, and points that no triangle uses. A triangle whose three corners lie on one line stays:
// without it the surface would open along that line.
//
// relativeTolerance >= 0: also merges points whose distance is at most this share of the diagonal
// of the bounding box. Merged points take the position of the first of them. With 0 only points at
// equal positions merge. If each point of a chain is near the next, the whole chain merges, so the
// merging distance must be far smaller than the edges. (1e-6 merges points that differ only by
// rounding.) Positions must be finite.
TriangleMesh weld(const TriangleMesh& mesh, double relativeTolerance = 0,
                  WeldReport* report = nullptr);

}  // namespace resect
