// Repair of a damaged mesh: orientation, holes, specks; with a report of what was changed.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct RepairReport {
  int trianglesTurned = 0;   // by orientConsistently()
  int componentsTurned = 0;  // by turnOutwards(), cavities included
  int specksDropped = 0;     // components without volume
  int holesClosed = 0;
  int trianglesAdded = 0;
  double areaAdded = 0;     // m^2
  double volumeBefore = 0;  // m^3, see closeHoles()
  double volumeAfter = 0;   // m^3, the same
};

// Each function takes a welded mesh, changes it in place and adds what it did to the report.
// Deterministic; O(n log n), except closeHoles().

// Flips triangles so that two triangles that share an edge have the same orientation. Edges of more
// than two triangles do not count. In each part connected over the other edges, the orientation of
// most triangles wins. A one-sided surface (Moebius strip) keeps some edges that do not agree.
void orientConsistently(TriangleMesh& mesh, RepairReport& report);

// Closes every hole of a mesh. Afterwards each edge is used equally often in both directions, so
// the mesh is closed and oriented, whatever it was before. A hole of up to 300 edges gets the
// triangulation of least area (Barequet and Sharir 1995; O(edges^3)). From a longer hole triangles
// are cut off first, each with the shortest new edge, until 300 edges are left. volumeBefore and
// volumeAfter are the signed volumes about the middle of the bounding box (volumeAbout() in
// measures.h), without and with the new triangles.
void closeHoles(TriangleMesh& mesh, RepairReport& report);

// Drops components without volume (isSpeck() in mesh_health.h). The mesh must be closed.
void dropSpecks(TriangleMesh& mesh, RepairReport& report);

// Flips every outermost component whose normals point inwards, and with it all components inside
// it, so that cavities stay cavities. The mesh must be closed and oriented.
void turnOutwards(TriangleMesh& mesh, RepairReport& report);

}  // namespace resect
