// Normals and cut shares of a brick's vertices.
//
// For pictures only; the simulation uses neither. A normal is the negative gradient of the field,
// normalised. The gradient is that of a 3D Sobel operator: central differences along one axis,
// averaged over the other two axes with weights 1 2 1 (Zucker and Hummel 1981 compare it with
// others). Plain central differences would show the lattice as ribs in the highlights. Mean error
// of the normals on a ball: 2.5 degrees with plain central differences and 1.6 with the Sobel
// operator at two nodes per cell, 1.3 with the Sobel operator at one node per cell.
//
// Cost: 1 500 operations per brick and 60 more per vertex.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"
#include "isosurface/brick_mesher.h"
#include "sph/colour_field.h"

namespace resect {

// Cut share of a surface point: 0 on the original surface to 1 well inside former tissue. before:
// the colour field's value at the point before any edit.
float cutShare(float before, float iso);

// Writes the normal (unit, towards less tissue) and the cut share of each vertex. edges: the edge
// of each vertex, as written by brickVertices(). Both output arrays may be overwritten up to the
// next multiple of CrossedEdges::kStep.
void brickLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
               std::span<const std::uint8_t> edges, Vec3f* normals, float* cut);

}  // namespace resect
