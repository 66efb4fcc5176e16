// The separate bodies into which an organ has been divided.
#pragma once

#include <vector>

#include "organ/organ.h"

namespace resect {

// The bodies that a closed surface bounds, the largest first. A component of the surface with
// positive volume bounds a body from outside. A component with negative volume bounds a cavity,
// which belongs to the smallest body round it. Each body is a closed mesh.
std::vector<TriangleMesh> bodies(const TriangleMesh& surface);

struct Body {
  TriangleMesh mesh;           // closed
  std::int64_t particles = 0;  // 0: a fragment without particles
  // Volume of the body's particles and of their skin cells, m^3. A skin cell holds some tissue
  // although it is not a particle itself; it belongs to a particle beside it (organ/organ.h).
  double tissue = 0;
  // For each label up to the highest label in the body: how much of `tissue` has this label, m^3.
  // The body's mass is the sum over the labels of this volume times the density of the label's
  // material.
  std::vector<double> tissueOf;
};

// The bodies of an organ that may have incisions, the largest first. The two lips of an incision
// lie at the same positions, so the bodies cannot be found from the surface alone. Two parts of the
// surface belong to one body if the tissue behind them is one piece (see tissuePieces()). A piece
// without particles, such as a sliver between two cuts, belongs to the body that it touches. The
// volumes of the meshes add up to the volume of the surface. The values of `tissue` add up to the
// volume of all particles. Cost: proportional to the number of grid nodes.
std::vector<Body> bodies(const Organ& organ);
// The same for tissue that has moved. surface: organ.surface.mesh(points) with the moved points.
std::vector<Body> bodies(const Organ& organ, const TriangleMesh& surface);

// The pieces of tissue. A piece is a set of grid nodes inside the tissue that are connected by grid
// edges that no cut crosses. The grid is that of the colour field, `organ.field`. The result has
// one value per node, in the order of the nodes with x fastest: the index of the node's piece, or
// -1 for a node outside the tissue. The indices of the pieces are in the order of their first
// nodes. If `count` is given, it receives the number of pieces.
std::vector<std::int32_t> tissuePieces(const Organ& organ, int* count = nullptr);

}  // namespace resect
