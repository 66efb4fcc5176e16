// Repairs a damaged mesh: drops triangles that lie on others, turns triangles, closes holes, drops
// specks (components without volume), and reports what was changed.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct RepairReport {
  int trianglesDoubled = 0;  // dropped by dropDoubled()
  int trianglesTurned = 0;   // flipped by orientConsistently()
  int componentsTurned = 0;  // flipped by turnOutwards(); includes cavities
  int specksDropped = 0;     // dropped by dropSpecks()
  int holesClosed = 0;       // by closeHoles(), as are the fields below
  int trianglesAdded = 0;
  double areaAdded = 0;     // m^2
  double volumeBefore = 0;  // m^3, see closeHoles()
  double volumeAfter = 0;   // m^3, see closeHoles()
};

// Each function takes a welded mesh and changes it in place. It adds to the report what was
// changed. The results are deterministic. Each function but closeHoles() takes O(n log n) for n
// triangles.

// Drops duplicate triangles: those with the same three corners as an earlier one, in the same or
// the opposite orientation. (Some programs write each face twice, once for each side.) A component
// is changed only if every triangle of it has a duplicate, and if the first triangles of all sets
// of duplicates form a closed surface. (A component of two coincident sheets is not changed, since
// one sheet alone is open. It is a speck.)
void dropDoubled(TriangleMesh& mesh, RepairReport& report);

// Flips triangles so that two triangles that share an edge have the same orientation. Edges of more
// than two triangles are ignored. In each part that is connected over the other edges, the
// orientation that most triangles have wins. In a one-sided surface (Moebius strip) the two
// triangles at some edges still disagree.
void orientConsistently(TriangleMesh& mesh, RepairReport& report);

// Closes every hole of a mesh. Afterwards each edge is used equally often in both directions, so
// the mesh is closed and oriented, whatever it was before. A hole of up to 300 edges gets the
// triangulation of least area (Barequet and Sharir 1995; O(edges^3)). A longer hole is first
// reduced to 300 edges: triangles are cut off it, each time the one with the shortest new edge.
// report.volumeBefore is the signed volume without the new triangles, report.volumeAfter the one
// with them. Both are taken about the middle of the bounding box (volumeAbout() in measures.h).
void closeHoles(TriangleMesh& mesh, RepairReport& report);

// Drops components without volume (isSpeck() in mesh_health.h). The mesh must be closed.
void dropSpecks(TriangleMesh& mesh, RepairReport& report);

// Looks at each component that is inside no other. If its normals point inwards, flips it and all
// components inside it, so that cavities stay cavities. The mesh must be closed and oriented.
void turnOutwards(TriangleMesh& mesh, RepairReport& report);

}  // namespace resect
