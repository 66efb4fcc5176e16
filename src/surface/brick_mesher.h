// What piece of the iso-surface lies in one brick of the colour field?
//
// Its vertices: those on the edges that belong to it (surface/crossed_edges.h). Cost: a few hundred
// operations for a brick.
#pragma once

#include "base/vec.h"
#include "sph/colour_field.h"
#include "surface/cell_kinds.h"
#include "surface/crossed_edges.h"

namespace resect {

// A vertex of the surface: where, which way is out, how far below the original skin.
struct SurfaceVertex {
  Vec3f position;  // rest space, m
  Vec3f normal;    // unit, towards less tissue
  float cut;       // 0 on the original skin ... 1 well inside what was tissue before any cut
};

// Writes signs.vertexCount() vertices, each part of them into an array of its own, and up to the
// next multiple of four some that lie in the brick and count for nothing.
void brickVertices(const ColourField& field, std::int64_t brick, const BrickSigns& signs, float iso,
                   Vec3f* points, Vec3f* normals, float* cut);

}  // namespace resect
