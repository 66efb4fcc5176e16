// Makes the closed, outward surface of an organ from a model, with a report of what was done.
#pragma once

#include <string>
#include <vector>

#include "geometry/repair/mesh_health.h"
#include "geometry/repair/repair.h"
#include "io/model.h"

namespace resect {

struct OrganMeshOptions {
  std::string part;     // use only the part of that name; empty: all parts together
  bool repair = false;  // close holes instead of refusing an open surface
  double metresPerUnit =
      1;  // > 0; what one unit of the file is, see parseUnit (io/scenario/length.h)
};

struct OrganMesh {
  TriangleMesh mesh;  // welded, closed, consistently oriented, looking outwards
  MeshHealth health;  // of that mesh
  RepairReport repairs;
  std::vector<std::string> notes;  // one sentence for each repair or doubt, for a person
};

struct WeldedSurface {
  TriangleMesh mesh;
  Topology topology;  // of that mesh
};

// Merges equal points; if that leaves the surface open, also points nearer than a millionth of the
// diagonal, provided that closes it (mirrored or rotated copies match only up to rounding).
WeldedSurface weldSurface(const TriangleMesh& mesh);

// Takes the part (or all), scales, welds, drops specks, orients outwards. Throws Error if the
// surface is open and `repair` is off (number of boundary edges, place of the first; the names of
// the parts when several were merged), if merged parts overlap, if the triangles cannot be oriented
// consistently, or if no volume is enclosed.
OrganMesh prepareOrganMesh(const Model& model, const OrganMeshOptions& options = {});

// The part of that name, or all parts as one; scaled to metres, otherwise unchanged.
TriangleMesh chosenSurface(const Model& model, const std::string& part, double metresPerUnit);

}  // namespace resect
