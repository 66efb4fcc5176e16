// Welding: merges points at the same position, so that triangles that meet there share one point.
//
// The result is the same on every machine: points keep the order in which they first appear, and
// triangles keep their order. A hash table finds points at equal positions, usually in O(n) for n
// points. A sorted list finds points that are only near each other.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct WeldReport {
  int mergedPoints = 0;         // points merged into another point
  int unusedPoints = 0;         // points dropped because no triangle uses them
  int degenerateTriangles = 0;  // triangles dropped because two of their corners are one point
};

// Merges points at equal positions. After that, drops triangles that have fewer than three
// different corners, and drops points that no triangle uses. A triangle with three different
// corners on one line is kept, since the surface would be open along this line without the
// triangle.
//
// relativeTolerance: >= 0. If it is 0, only points at equal positions are merged. If it is above 0,
// two points are also merged if their distance is at most this fraction of the diagonal of the
// bounding box. (A fraction of 1e-6 merges points that differ only by rounding.) Merged points take
// the position of the first of them. If each point of a chain is near the next one, the whole chain
// becomes one point. So the merging distance must be far smaller than the edges of the mesh. All
// positions must be finite.
TriangleMesh weld(const TriangleMesh& mesh, double relativeTolerance = 0,
                  WeldReport* report = nullptr);

}  // namespace resect
