// Repairs a damaged mesh. The functions drop duplicate triangles, flip triangles, close holes, and
// drop specks (components without volume). They report what they have changed.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct RepairReport {
  int trianglesDoubled = 0;  // triangles that dropDoubled() has dropped
  int trianglesTurned = 0;   // triangles that orientConsistently() has flipped
  int componentsTurned = 0;  // components that turnOutwards() has flipped, cavities included
  int specksDropped = 0;     // components that dropSpecks() has dropped
  // closeHoles() sets the fields below.
  int holesClosed = 0;
  int trianglesAdded = 0;
  double areaAdded = 0;     // m^2
  double volumeBefore = 0;  // m^3, see closeHoles()
  double volumeAfter = 0;   // m^3, see closeHoles()
};

// Each function takes a welded mesh, changes it in place, and adds to the report what it has
// changed. The results are deterministic. Cost for n triangles: O(n log n), except for
// closeHoles().

// Drops duplicate triangles. A triangle is a duplicate if an earlier triangle has the same three
// corners, in the same or the opposite orientation. (Some programs write each face twice, once for
// each side.) A component is changed only if two conditions hold: every triangle of the component
// occurs more than once, and the component without its duplicates is a closed surface. (So a
// component of two coincident sheets is not changed, since one sheet alone is open. Such a
// component is a speck.)
void dropDoubled(TriangleMesh& mesh, RepairReport& report);

// Flips triangles to give neighbouring triangles the same orientation. Two triangles are neighbours
// if they share an edge that belongs to no third triangle. Triangles that are connected by a chain
// of neighbours all get the same orientation: the one that most of them had. For a one-sided
// surface (Moebius strip) this is impossible, so some neighbours have different orientations
// afterwards.
void orientConsistently(TriangleMesh& mesh, RepairReport& report);

// Closes every hole of a mesh. Afterwards triangles use each edge equally often in both directions,
// so the mesh is closed and oriented, whatever it was before. A hole of n <= 300 edges gets the
// triangulation of least area (Barequet and Sharir 1995), which takes O(n^3). A longer hole is
// first reduced to 300 edges. To reduce it, triangles are cut off one after the other; the next one
// is always the triangle with the shortest new edge. report.volumeBefore is the signed volume of
// the mesh without the new triangles. report.volumeAfter is the signed volume with the new
// triangles. Both volumes are computed about the middle of the bounding box (volumeAbout() in
// geometry/measures.h).
void closeHoles(TriangleMesh& mesh, RepairReport& report);

// Drops specks, which are components without volume (isSpeck() in geometry/repair/mesh_health.h).
// The mesh must be closed.
void dropSpecks(TriangleMesh& mesh, RepairReport& report);

// Examines each component that is inside no other component. If the normals of such a component
// point inwards, flips it together with all components inside it, so that cavities stay cavities.
// The mesh must be closed and oriented.
void turnOutwards(TriangleMesh& mesh, RepairReport& report);

}  // namespace resect
