// How does the surface look in one brick: which way is out, and what of it is cut?
//
// For pictures only: the simulation needs neither, and asks for neither. The way out is down the
// field's slope, whose differences along an axis are averaged over the nodes beside it with the
// weights 1 2 1 across (Sobel's operator in space; Zucker and Hummel 1981 compare such). Plain
// differences show every cell of the lattice as a rib in the highlights: on a ball their mean error
// is 2.5 degrees with two nodes a cell, that of these 1.6, and 1.3 with one.
//
// Cost: 1 500 operations for a brick, 60 for a vertex.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"
#include "isosurface/brick_mesher.h"
#include "sph/colour_field.h"

namespace resect {

// How much of a surface counts as cut, from the colour field's value there before any edit: 0 on
// the original skin ... 1 well inside what was tissue.
float cutShare(float before, float iso);

// What brickVertices() wrote to `edges` comes back. normals: unit, towards less tissue; cut: as
// above. What follows them up to the next multiple of CrossedEdges::kStep may be written too.
void brickLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
               std::span<const std::uint8_t> edges, Vec3f* normals, float* cut);

}  // namespace resect
