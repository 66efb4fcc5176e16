// Makes the closed surface of an organ from a model, oriented outwards, with a report of what was
// changed.
#pragma once

#include <string>
#include <vector>

#include "geometry/repair/mesh_health.h"
#include "geometry/repair/repair.h"
#include "io/model.h"

namespace resect {

struct OrganMeshOptions {
  std::string part;          // name of the part to use; empty: all parts together
  bool repair = false;       // close holes instead of refusing an open surface
  double metresPerUnit = 1;  // > 0; metres per unit of the model's coordinates
};

struct OrganMesh {
  TriangleMesh mesh;  // welded, closed, consistently oriented outwards
  MeshHealth health;  // of `mesh`
  RepairReport repairs;
  std::vector<std::string> notes;  // one sentence for people about each repair or doubt
};

struct WeldedSurface {
  TriangleMesh mesh;
  Topology topology;  // of `mesh`
};

// Merges points at equal positions. If the surface is then still open, points that are at most a
// millionth of the bounding box's diagonal apart are merged too. This second merging is kept only
// if it closes the surface. It is needed for mirrored or rotated copies, whose points match those
// of the original only up to rounding.
WeldedSurface weldSurface(const TriangleMesh& mesh);

// Takes the chosen part, or all parts, and scales and welds the surface. Then closes its holes if
// `repair` is on, drops specks (components without volume) and orients the rest outwards. Throws
// Error in these cases:
// - The surface is open and `repair` is off. The Error has the number of boundary edges and the
//   position of the first. If the model has several parts and all were taken, it also has their
//   names.
// - The surface is open, all of several parts were taken, and more than two triangles meet at some
//   edge. Its holes are then not closed, even if `repair` is on. The Error is as above.
// - The triangles cannot be oriented consistently.
// - The triangles enclose no volume.
OrganMesh prepareOrganMesh(const Model& model, const OrganMeshOptions& options = {});

// The part named `part`, or all parts as one mesh if `part` is empty. Points are scaled to metres;
// nothing else is changed.
TriangleMesh chosenSurface(const Model& model, const std::string& part, double metresPerUnit);

}  // namespace resect
