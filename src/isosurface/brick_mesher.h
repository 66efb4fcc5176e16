// Vertices of the iso-surface in one brick of the colour field.
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

// A vertex keeps at least this fraction of its edge away from both ends of the edge, so that no two
// vertices coincide.
constexpr float kEndMargin = 1e-3f;

// Distances between neighbouring nodes of a field along each axis, and the iso level.
struct NodeGrid {
  float iso;
  Vec3 step;                  // rest space, m
  Vec3f spacing, perSpacing;  // step as floats; 1 / step

  NodeGrid(const ColourField& field, float level)
      : iso(level),
        step(field.lattice().spacing / field.refine()),
        spacing(step.cast<float>()),
        perSpacing(spacing.cwiseInverse()) {}
};

// Writes, for each of the signs.vertexCount() vertices, its position (rest space, m) and the number
// of the edge that it lies on. Both arrays may be overwritten up to the next multiple of
// CrossedEdges::kStep.
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, std::uint8_t* edges);

}  // namespace resect
