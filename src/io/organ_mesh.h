// Makes the closed, outward surface of an organ from a model, with a report of what was done.
#pragma once

#include <string>
#include <vector>

#include "geometry/repair/mesh_health.h"
#include "geometry/repair/repair.h"
#include "io/model.h"

namespace resect {

struct OrganMeshOptions {
  std::string part;          // use only the part of that name; empty: all parts together
  bool repair = false;       // close holes instead of refusing an open surface
  double metresPerUnit = 1;  // > 0; metres per unit of the model's coordinates
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

// Merges equal points. If the surface is then still open, also merges points that are nearer to
// each other than a millionth of the bounding box's diagonal, but only if that closes the surface:
// mirrored or rotated copies match only up to rounding.
WeldedSurface weldSurface(const TriangleMesh& mesh);

// Takes the part (or all), scales it, welds it, closes its holes if `repair` is on, drops specks
// (components without volume) and orients the rest outwards. Throws Error if the surface is open
// and `repair` is off, or is open and several parts were merged that share edges; the Error has the
// number of boundary edges, the position of the first and, for merged parts, their names. Also
// throws Error if the triangles cannot be oriented consistently, or if they enclose no volume.
OrganMesh prepareOrganMesh(const Model& model, const OrganMeshOptions& options = {});

// The part of that name, or all parts as one mesh if `part` is empty; scaled to metres, otherwise
// unchanged.
TriangleMesh chosenSurface(const Model& model, const std::string& part, double metresPerUnit);

}  // namespace resect
