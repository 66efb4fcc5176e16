// Repair of a damaged mesh: orientation, holes, specks; with a report of what was changed.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

struct RepairReport {
  int trianglesTurned = 0;   // to make neighbours agree
  int componentsTurned = 0;  // whole bodies that were inside out
  int specksDropped = 0;     // components without volume
  int holesClosed = 0;
  int trianglesAdded = 0;
  double areaAdded = 0;     // m^2
  double volumeBefore = 0;  // m^3, see below
  double volumeAfter = 0;   // m^3
};

// Each function takes a welded mesh, changes it in place and adds what it did to the report.
// Deterministic; O(n log n) but for the holes.

// Flips triangles so that neighbours over an edge of two triangles agree; per component the
// orientation of most triangles wins. A one-sided surface (Moebius) keeps some disagreeing edges.
void orientConsistently(TriangleMesh& mesh, RepairReport& report);

// Closes every hole of a mesh: afterwards each edge is used equally often in both directions, so
// the mesh is closed and oriented, whatever it was before. A hole of up to 300 edges gets the
// triangulation of least area (Barequet and Sharir 1995; O(edges^3)), a longer one is first
// shortened, always by its shortest diagonal. volumeBefore and volumeAfter are the signed sums of
// the tetrahedra with the middle of the bounding box, without and with the new triangles.
void closeHoles(TriangleMesh& mesh, RepairReport& report);

// Drops components without volume (isSpeck). The mesh must be closed.
void dropSpecks(TriangleMesh& mesh, RepairReport& report);

// Flips every outermost component with inward normals, together with all components inside it, so
// that cavities stay cavities. The mesh must be closed and oriented.
void turnOutwards(TriangleMesh& mesh, RepairReport& report);

}  // namespace resect
