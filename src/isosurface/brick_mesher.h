// What piece of the iso-surface lies in one brick of the colour field?
//
// Its vertices: those on the edges that belong to it (isosurface/crossed_edges.h). How they look is
// in isosurface/brick_look.h. Cost: some hundred operations for a brick, 25 for a vertex.
#pragma once

#include "base/vec.h"
#include "isosurface/cell_kinds.h"
#include "isosurface/crossed_edges.h"
#include "sph/colour_field.h"

namespace resect {

// Vertices keep this share of an edge away from its ends, so that no two of them fall together.
constexpr float kEndMargin = 1e-3f;

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

// Writes the places of signs.vertexCount() vertices (rest space, m), and on which edge each lies.
// What follows them up to the next multiple of CrossedEdges::kStep may be written too, and counts
// for nothing.
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, std::uint8_t* edges);

}  // namespace resect
