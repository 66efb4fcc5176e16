// Normals and cut shares of a brick's vertices. A brick is a block of 4 x 4 x 4 nodes of the colour
// field.
//
// A cut share says whether a vertex lies on the organ's original surface or on a cut (cutShare()).
// Only pictures need normals and cut shares. A normal is the negative gradient of the field,
// normalised. The gradient is found by a 3D Sobel operator: central differences along one axis,
// averaged over the other two axes with weights 1 2 1. (Zucker and Hummel 1981 compare this
// operator with others.) Plain central differences would show the lattice as ribs in the
// highlights. The mean error of the normals was measured on a ball. With two nodes per cell of the
// organ along each axis, it is 2.5 degrees for plain central differences and 1.6 degrees for the
// Sobel operator. With one node per cell, the Sobel operator averages over a wider range, and its
// error is 1.3 degrees.
//
// Cost: 1 500 operations per brick and 60 more per vertex.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"
#include "isosurface/brick_mesher.h"
#include "sph/colour_field.h"

namespace resect {

// The cut share of a surface point: from 0 on the original surface to 1 well inside former tissue.
// before: value of the colour field at the point before any edit. iso: the iso level.
float cutShare(float before, float iso);

// This value replaces the cut share of a vertex that belongs to the organ's outer surface and lies
// on the rim of a cut. Viewers draw the rim as a thin line.
constexpr float kRimShare = -1;

// Writes the normal (unit, towards less tissue) and the cut share of each vertex. edges: for each
// vertex, the number of the grid edge on which it lies, as written by brickVertices(). `normals`
// and `cut` must have room up to the next multiple of CrossedEdges::kStep; elements beyond the last
// vertex are overwritten.
void brickLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
               std::span<const std::uint8_t> edges, Vec3f* normals, float* cut);

}  // namespace resect
