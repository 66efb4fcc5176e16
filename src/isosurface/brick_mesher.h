// Vertices of the iso-surface in one brick of the colour field, which is a block of 4 x 4 x 4
// nodes.
//
// The vertices lie on the grid edges that belong to the brick (isosurface/crossed_edges.h). Their
// normals come from isosurface/brick_look.h. Cost: about 100 operations per brick and 25 more per
// vertex.
#pragma once

#include "base/vec.h"
#include "isosurface/cell_kinds.h"
#include "isosurface/crossed_edges.h"
#include "sph/colour_field.h"

namespace resect {

// The distance of a vertex from each end of its grid edge is at least this fraction of the edge's
// length. So no two vertices coincide.
constexpr float kEndMargin = 1e-3f;

// The iso level, and the distance between neighbouring nodes of a field along each axis.
struct NodeGrid {
  float iso;
  Vec3 step;                  // rest space, m
  Vec3f spacing, perSpacing;  // `step` as floats, and 1 / `step`

  NodeGrid(const ColourField& field, float level)
      : iso(level),
        step(field.lattice().spacing / field.refine()),
        spacing(step.cast<float>()),
        perSpacing(spacing.cwiseInverse()) {}
};

// Writes, for each of the signs.vertexCount() vertices, its position (rest space, m) and the number
// of the edge that it lies on. Elements of both arrays beyond the last vertex may be overwritten,
// up to the next multiple of CrossedEdges::kStep.
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, std::uint8_t* edges);

}  // namespace resect
