// Normals and cut shares of a brick's vertices.
//
// For pictures only; the simulation uses neither. The normal is the negative gradient of the field
// by a 3D Sobel operator: central differences averaged across with weights 1 2 1 (compared with
// others by Zucker and Hummel 1981). Plain central differences show the lattice as ribs in the
// highlights: on a ball their mean error is 2.5 degrees with two nodes a cell, that of the Sobel
// operator 1.6, and 1.3 with one.
//
// Cost: 1 500 operations for a brick, 60 for a vertex.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"
#include "isosurface/brick_mesher.h"
#include "sph/colour_field.h"

namespace resect {

// Cut share of a surface point from the colour field's value there before any edit: 0 on the
// original surface to 1 well inside former tissue.
float cutShare(float before, float iso);

// edges: as written by brickVertices(). normals: unit, towards less tissue; cut: as above. Both may
// be written up to the next multiple of CrossedEdges::kStep.
void brickLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
               std::span<const std::uint8_t> edges, Vec3f* normals, float* cut);

}  // namespace resect
