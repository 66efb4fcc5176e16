// Vertices of the iso-surface in one brick of the colour field.
//
// The vertices lie on the grid edges that belong to the brick (isosurface/crossed_edges.h). Their
// normals come from isosurface/brick_look.h. Cost: some hundred operations per brick and 25 more
// per vertex.
#pragma once

#include "base/vec.h"
#include "isosurface/cell_kinds.h"
#include "isosurface/crossed_edges.h"
#include "sph/colour_field.h"

namespace resect {

// Vertices stay away from both ends of their edge by this fraction of it, so that no two of them
// coincide.
constexpr float kEndMargin = 1e-3f;

// Distances between a field's nodes, and the iso level.
struct NodeGrid {
  float iso;
  Vec3 step;                  // from node to node (rest space, m)
  Vec3f spacing, perSpacing;  // step as floats, and its inverse

  NodeGrid(const ColourField& field, float level)
      : iso(level),
        step(field.lattice().spacing / field.refine()),
        spacing(step.cast<float>()),
        perSpacing(spacing.cwiseInverse()) {}
};

// Writes the positions of signs.vertexCount() vertices (rest space, m) and the number of the edge
// that each lies on. Both arrays may be overwritten up to the next multiple of CrossedEdges::kStep.
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, std::uint8_t* edges);

}  // namespace resect
