// Makes the closed surface of an organ from a model, oriented outwards, and reports the changes.
#pragma once

#include <string>
#include <vector>

#include "geometry/repair/mesh_health.h"
#include "geometry/repair/repair.h"
#include "geometry/repair/shells.h"
#include "io/model.h"

namespace resect {

struct OrganMeshOptions {
  std::string part;          // names of the parts to join, one per line; empty: all parts
  bool repair = false;       // true: holes are closed; false: an open surface is an error
  double metresPerUnit = 1;  // > 0; metres per unit of the model's coordinates
  // Names of parts, one per line, that are known to be structures within the organ's tissue. The
  // shells (geometry/repair/shells.h) of these parts get no note.
  std::string structures = {};
};

struct OrganMesh {
  TriangleMesh mesh;  // welded, closed, consistently oriented outwards
  MeshHealth health;  // of `mesh`
  double volume = 0;  // of the tissue, m^3, without cavities
  // The shells of the surface, including those that are not in `mesh`; empty if there is only one
  // shell. Shells of the kind Within bound no tissue. `mesh` contains such a shell only if the
  // shell intersects a shell of another kind.
  std::vector<Shell> shells;
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

// Makes the closed surface of an organ in these steps:
// 1. Joins the chosen parts, or all parts, and scales and welds the surface.
// 2. In components in which every triangle occurs more than once, drops the copies (dropDoubled()).
// 3. Closes the holes, if `repair` is on.
// 4. Drops specks (components without volume), and orients the other components outwards.
// Throws Error in these cases:
// - The surface is open and `repair` is off. The Error gives the number of boundary edges and the
//   position of the first one. If several parts were joined, it also gives their names. If the
//   surface does not have the size of an organ, the Error ends with a sentence about the size
//   (sizeDoubt()).
// - The surface is open, several parts were joined, and more than two triangles meet at some edge.
//   The holes of such a surface are not closed, even if `repair` is on. The Error says the same as
//   in the first case.
// - The triangles cannot be oriented consistently.
// - The triangles enclose no volume.
OrganMesh prepareOrganMesh(const Model& model, const OrganMeshOptions& options = {});

// The parts named by `part` (as in OrganMeshOptions) as one mesh, scaled to metres. Nothing else is
// changed.
TriangleMesh chosenSurface(const Model& model, const std::string& part, double metresPerUnit);

}  // namespace resect
