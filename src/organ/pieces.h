// The separate bodies into which an organ has been divided.
#pragma once

#include <vector>

#include "organ/organ.h"

namespace resect {

// The separate solid bodies that a closed surface bounds, the largest first. A component of the
// surface with positive volume bounds a body from outside; one with negative volume bounds a cavity
// in the smallest body round it. Each body is a closed mesh.
std::vector<TriangleMesh> bodies(const TriangleMesh& surface);

struct Body {
  TriangleMesh mesh;           // closed
  std::int64_t particles = 0;  // 0: a fragment smaller than a particle
  double tissue = 0;           // m^3 of its particles, skin included
  // The share of `tissue` of each label, m^3, up to the body's highest label; the body's mass is
  // the sum of these times the labels' densities.
  std::vector<double> tissueOf;
};

// The same for an organ with incisions. The lips of an incision coincide, so here two parts of the
// surface belong to one body if whole edges of the grid connect their tissue. A sliver between two
// cuts that holds no particle belongs to the body that it touches. The meshes' volumes add up to
// the surface's, the tissue to that of the organ's particles. O(grid nodes).
std::vector<Body> bodies(const Organ& organ);
// The same where the tissue has moved; surface: organ.surface.mesh(points), with the moved points.
std::vector<Body> bodies(const Organ& organ, const TriangleMesh& surface);

// Per node of the field's grid, x fastest: the piece of tissue that contains it, -1 outside. Pieces
// are numbered in the order of their first node. `count`, if given, receives their number.
std::vector<std::int32_t> tissuePieces(const Organ& organ, int* count = nullptr);

}  // namespace resect
