// The separate bodies into which an organ has been divided.
#pragma once

#include <vector>

#include "organ/organ.h"

namespace resect {

// The separate solid bodies that a closed surface bounds, the largest first: a component of
// positive volume is the surface of a body; one of negative volume is a cavity of the smallest body
// round it. Each body is a closed mesh.
std::vector<TriangleMesh> bodies(const TriangleMesh& surface);

struct Body {
  TriangleMesh mesh;             // closed
  std::int64_t particles = 0;    // 0: a fragment smaller than a particle
  double tissue = 0;             // m^3 of its particles, skin included
  std::vector<double> tissueOf;  // m^3 of it per label, up to the highest that it holds; times the
                                 // labels' densities: its mass
};

// The same for an organ with incisions, whose lips coincide: two parts of the surface belong to one
// body if their tissue is connected over whole edges of the grid. A sliver between two cuts without
// a particle belongs to the body that it touches. The meshes' volumes add up to the surface's, the
// tissue to the organ's. O(grid nodes).
std::vector<Body> bodies(const Organ& organ);
// The same where the tissue has moved; surface: organ.surface.mesh(points).
std::vector<Body> bodies(const Organ& organ, const TriangleMesh& surface);

// Per node of the field's grid, x fastest: the piece of tissue that contains it, -1 outside. Pieces
// are numbered in the order of their first node.
std::vector<std::int32_t> tissuePieces(const Organ& organ, int* count = nullptr);

}  // namespace resect
