// Vertices and triangles of wounds in one brick of the colour field.
//
// A brick's vertices are its iso vertices (isosurface/brick_mesher.h), followed by the vertices
// that cuts add: two for each cut edge, then those of faces, then those of cells. Edges and faces
// are ordered by axis, then by node; cells are ordered by node. So neighbouring bricks find these
// vertices by counting bits. Where a lip meets the organ's surface, a vertex has a twin at the same
// position with the lip's normal and cut share (isosurface/brick_look.h), so that the edge of a
// wound looks sharp. Cost: 2 us per cut cell, and about 10 us per brick.
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
    float cut;          // cut share, 0 to 1, or kRimShare
    bool twin = false;  // whether this is the twin of the vertex before it
  };
  // A corner below kFirstCellVertex is a CellVertex of the cell (wound_loops.h). From any other
  // corner, subtract kFirstCellVertex to get an index into `vertices`.
  struct Triangle {
    std::uint8_t cell;  // number in the brick
    bool lip;           // true: part of a lip; false: part of the organ's surface
    std::array<std::int16_t, 3> corners;
  };

  std::uint64_t cells = 0;  // cut cells (isCutCell()); bit n: the cell whose lowest node is node n
  // One mask per axis. A bit stands for an edge by its lower node, or for a face by its lowest
  // node.
  std::array<std::uint64_t, 3> edges{};      // edges that are cut
  std::array<std::uint64_t, 3> faces{};      // faces that have vertices
  std::array<std::uint64_t, 3> skinFaces{};  // faces whose vertices have twins
  std::vector<std::int16_t> firstOfFace;     // per face of `faces`, in order: its first vertex
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  // The binding and one anchor of each vertex: first for the brick's iso vertices, then for
  // `vertices`. An anchor is given as an offset from the brick's first node.
  std::vector<VertexBinding> bindings;
  std::vector<std::array<std::int8_t, 3>> anchors;
  int unbalanced = 0;  // number of cells whose volume could not be kept
  // Whether the result depends on more than the brick's own cells and the lattice cubes that
  // contain them.
  bool looksFar = false;
  // Whether the last call of makeBrickWound() changed vertex numbers that neighbouring bricks use.
  bool renumbered = false;

  // Both functions return an index into `vertices`. side: kLower or kUpper. number: which of the
  // face's vertices, from 0, twins not counted. lip: true for the twin, which has the lip's normal;
  // without effect if the face's vertices have no twins.
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

// Computes the wound of a brick. signs: of this brick; its iso vertices get bindings too. out: on
// entry the brick's previous result (empty if there is none), on return the new one.
void makeBrickWound(const ColourField& field, const Wound& wound, const Vec3i& brick,
                    const BrickSigns& signs, float iso, BrickWound& out);

}  // namespace resect
