// Makes the closed surface of an organ from a model, oriented outwards, with a report of what was
// changed.
#pragma once

#include <string>
#include <vector>

#include "geometry/repair/mesh_health.h"
#include "geometry/repair/repair.h"
#include "geometry/repair/shells.h"
#include "io/model.h"

namespace resect {

struct OrganMeshOptions {
  std::string part;     // names of the parts to use, joined, one a line; empty: all parts together
  bool repair = false;  // close holes instead of refusing an open surface
  double metresPerUnit = 1;  // > 0; metres per unit of the model's coordinates
};

struct OrganMesh {
  TriangleMesh mesh;          // welded, closed, consistently oriented outwards
  MeshHealth health;          // of `mesh`
  double volume = 0;          // of its tissue, m^3: without cavities, and nothing counted twice
  std::vector<Shell> shells;  // of `mesh`, if there are several
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

// Takes the chosen parts, or all parts, and scales and welds the surface. Drops triangles that lie
// on others if all do (dropDoubled()). Then closes its holes if `repair` is on, drops specks
// (components without volume) and orients the rest outwards. Throws Error in these cases:
// - The surface is open and `repair` is off. The Error has the number of boundary edges and the
//   position of the first. If several parts were taken, it also has their names. It ends with the
//   doubt about the size, if any (sizeDoubt()).
// - The surface is open, several parts were taken, and more than two triangles meet at some edge.
// Its holes are then not closed, even if `repair` is on. The Error is as above.
// - The triangles cannot be oriented consistently.
// - The triangles enclose no volume.
OrganMesh prepareOrganMesh(const Model& model, const OrganMeshOptions& options = {});

// The parts named by `part` (as in OrganMeshOptions) as one mesh, scaled to metres. Nothing else is
// changed.
TriangleMesh chosenSurface(const Model& model, const std::string& part, double metresPerUnit);

}  // namespace resect
