// Vertices and triangles of wounds in one brick (block of 4 x 4 x 4 nodes) of the colour field.
//
// A brick's vertices begin with its iso vertices, which lie where edges cross the iso level
// (isosurface/brick_mesher.h). The vertices that cuts add come next: two vertices for each cut
// edge, then the vertices in faces, then the vertices in cells. Edges and faces are ordered by
// axis, then by node. Cells are ordered by node. Because of this order, neighbouring bricks find
// the numbers of these vertices by counting bits in masks. Where a lip (one of the two sides of a
// cut) meets the organ's surface, a vertex has a twin at the same position. For shading, the twin
// has the lip's normal and cut share (isosurface/brick_look.h), so that the rim of the wound looks
// sharp. Cost: 2 us per cut cell, and about 10 us per brick.
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
  std::span<const std::uint8_t> particles;  // per lattice cell: 1 if it is a particle
  // m: width of the gap between the two lips of a cut. Vertices of both lips are moved into their
  // tissue by half of it. Vertices at the front of a cut, where the lips meet, stay.
  float kerf = 0;
};

struct BrickWound {
  struct Vertex {
    Vec3f position;     // rest space, m
    Vec3f normal;       // unit, out of the tissue
    float cut;          // cut share, 0 to 1, or kRimShare
    bool twin = false;  // whether this is the twin of the vertex before it
  };
  // A value in `corners` below kFirstCellVertex is a CellVertex of the cell (wound_loops.h). Any
  // other value is kFirstCellVertex plus an index into `vertices`.
  struct Triangle {
    std::uint8_t cell;  // number of the cell in the brick
    bool lip;           // true: part of a lip; false: part of the organ's surface
    std::array<std::int16_t, 3> corners;
  };

  std::uint64_t cells = 0;  // cut cells (isCutCell()); bit n: cell with lowest node n
  // One mask per axis. Bit n stands for the edge whose lower node, or for the face whose lowest
  // node, is node n of the brick.
  std::array<std::uint64_t, 3> edges{};      // edges that are cut
  std::array<std::uint64_t, 3> faces{};      // faces with a point at which lines bend
  std::array<std::uint64_t, 3> skinFaces{};  // faces whose vertices have twins
  std::vector<std::int16_t> firstOfFace;     // per face in `faces`: its first vertex
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  // The binding and one anchor of each vertex. The brick's iso vertices come first, then
  // `vertices`. An anchor is given as an offset from the brick's first node.
  std::vector<VertexBinding> bindings;
  std::vector<std::array<std::int8_t, 3>> anchors;
  int unbalanced = 0;  // number of cells whose volume could not be kept
  // Whether the result depends on data outside the brick's own cells and outside the lattice cubes
  // that contain these cells.
  bool looksFar = false;
  // Whether the last call of makeBrickWound() changed vertex numbers that neighbouring bricks use.
  bool renumbered = false;

  // edgeVertex() and faceVertex() return an index into `vertices`. node: the lower node of the
  // edge, or the lowest node of the face. side: kLower or kUpper. number: number of the vertex
  // among the face's vertices, from 0; twins are not counted. lip: true for the twin, which has the
  // lip's normal; has no effect if the face's vertices have no twins.
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

// Computes the wound of a brick. signs: which edges of the brick cross the surface. The iso
// vertices on these edges get bindings too. out: on entry, the previous result for the brick, or an
// empty object if there is none; on return, the new result.
void makeBrickWound(const ColourField& field, const Wound& wound, const Vec3i& brick,
                    const BrickSigns& signs, float iso, BrickWound& out);

}  // namespace resect
