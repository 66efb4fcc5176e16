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

// Where a field's nodes lie to each other, and at which level the surface runs.
struct NodeGrid {
  float iso;
  Vec3 step;                  // from node to node (rest space, m)
  Vec3f spacing, perSpacing;  // the same, and 1 over it

  NodeGrid(const ColourField& field, float level)
      : iso(level),
        step(field.lattice().spacing / field.refine()),
        spacing(step.cast<float>()),
        perSpacing(spacing.cwiseInverse()) {}
};

// Writes signs.vertexCount() vertices, each part of them into an array of its own; edges: on which
// edge each lies. What follows them up to the next multiple of CrossedEdges::kStep may be written
// too, and counts for nothing.
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, Vec3f* normals, float* cut,
                   std::uint8_t* edges);

}  // namespace resect
