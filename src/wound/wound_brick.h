// Vertices and triangles of wounds in one brick of the colour field.
//
// To a brick's iso vertices (isosurface/brick_mesher.h) are added the vertices that cuts make: two
// for each cut edge, then those of the faces, then those of the cells, each group in the order of
// nodes. Neighbouring bricks find these vertices by counting bits. Where a lip meets the organ's
// surface, a vertex has a twin at the same position with the lip's normal and cut share, so that
// the edge of a wound looks sharp. Cost: 2 us per cut cell, and some 10 us per brick.
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "isosurface/brick_mesher.h"
#include "wound/vertex_binding.h"
#include "wound/wound_cells.h"

namespace resect {

// Input of the surface tracker for an organ with incisions.
struct Wound {
  const SeveredEdges& severed;
  std::span<const std::uint8_t> particles;  // per lattice cell: 1 where a particle is
};

struct BrickWound {
  struct Vertex {
    Vec3f position;     // rest space, m
    Vec3f normal;       // unit, out of the tissue
    float cut;          // cut share, 0 to 1
    bool twin = false;  // whether it is the twin of the vertex before it
  };
  // A corner below kFirstCellVertex is a CellVertex of the cell (wound_loops.h). Any other is
  // kFirstCellVertex + an index into `vertices`.
  struct Triangle {
    std::uint8_t cell;
    bool lip;
    std::array<std::int16_t, 3> corners;
  };

  std::uint64_t cells = 0;                   // cells drawn by the wound's rules
  std::array<std::uint64_t, 3> edges{};      // per axis, bit = lower node: edges that are cut
  std::array<std::uint64_t, 3> faces{};      // likewise: faces that have vertices
  std::array<std::uint64_t, 3> skinFaces{};  // likewise: faces whose vertices have twins
  std::vector<std::int16_t> firstOfFace;     // first vertex of each face, in the order of `faces`
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  // First for the brick's iso vertices, then for `vertices`: the binding and one anchor of each.
  // The anchor is given as an offset from the brick's first node.
  std::vector<VertexBinding> bindings;
  std::vector<std::array<std::int8_t, 3>> anchors;
  int unbalanced = 0;  // cells whose volume could not be kept
  // Whether the result depends on more than the brick's own cells and lattice cubes.
  bool looksFar = false;
  // Whether the last call of makeBrickWound() changed vertex numbers that neighbouring bricks use.
  bool renumbered = false;

  // edgeVertex() and faceVertex() give indices into `vertices`.
  int edgeVertex(int axis, int node, int side) const {
    int before = std::popcount(edges[std::size_t(axis)] & ((std::uint64_t(1) << node) - 1));
    for (int a = 0; a < axis; ++a) before += std::popcount(edges[std::size_t(a)]);
    return 2 * before + side;
  }
  int faceVertex(int axis, int node, int number, bool lip) const {
    int before = std::popcount(faces[std::size_t(axis)] & ((std::uint64_t(1) << node) - 1));
    for (int a = 0; a < axis; ++a) before += std::popcount(faces[std::size_t(a)]);
    const bool twins = skinFaces[std::size_t(axis)] >> node & 1;
    return firstOfFace[std::size_t(before)] + (twins ? 2 * number + lip : number);
  }
};

// Computes the wound of a brick. signs: of the brick; its iso vertices are bound too.
void makeBrickWound(const ColourField& field, const Wound& wound, const Vec3i& brick,
                    const BrickSigns& signs, float iso, BrickWound& out);

}  // namespace resect
