// The triangles of a brick, with vertices that it shares with the bricks above it.
#include <algorithm>
#include <array>
#include <bit>

#include "base/instruction_set.h"
#include "isosurface/cell_triangles.h"
#include "isosurface/marching_cubes_table.h"
#include "surface/surface_tracker.h"

namespace resect {
namespace {

// Index in an EdgeTable of each of a brick's own edges (isosurface/crossed_edges.h).
constexpr std::array<std::uint16_t, kNoEdge + 1> kOwnIndex = [] {
  std::array<std::uint16_t, kNoEdge + 1> indices{};
  for (int edge = 0; edge < kBrickEdges; ++edge)
    indices[std::size_t(edge)] =
        std::uint16_t(EdgeTable::index(edge / kBrickSize, edge & 3, edge >> 2 & 3, edge >> 4 & 3));
  indices[kNoEdge] = EdgeTable::kNone;
  return indices;
}();

// An edge of a brick's cells that belongs to one of the bricks above.
struct SharedEdge {
  std::uint8_t owner, axis, node;  // owner: 1 for a step along x, 2 along y, 4 along z
  std::uint16_t index;
};
constexpr int kSharedEdges = 3 * 32 + 3 * 4;
using SharedCrossings = std::array<std::uint64_t, 2>;  // which of them are crossed

// In the order of sharedCrossings().
constexpr std::array<SharedEdge, kSharedEdges> kSharedEdge = [] {
  std::array<SharedEdge, kSharedEdges> edges{};
  std::size_t n = 0;
  const auto add = [&](int owner, int axis, int node) {
    const int index = EdgeTable::index(axis, (node & 3) + kBrickNodes * (owner & 1),
                                       (node >> 2 & 3) + kBrickNodes * (owner >> 1 & 1),
                                       (node >> 4) + kBrickNodes * (owner >> 2));
    edges[n++] = {std::uint8_t(owner), std::uint8_t(axis), std::uint8_t(node),
                  std::uint16_t(index)};
  };
  for (int node = 0; node < kBrickSize; node += 4)
    for (const int axis : {1, 2}) add(1, axis, node);
  for (int z = 0; z < kBrickNodes; ++z)
    for (const int axis : {0, 2})
      for (int x = 0; x < kBrickNodes; ++x) add(2, axis, 16 * z + x);
  for (const int axis : {0, 1})
    for (int node = 0; node < 16; ++node) add(4, axis, node);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < kBrickNodes; ++i) add(7 - (1 << axis), axis, i << 2 * axis);
  return edges;
}();

}  // namespace

// The brick and its seven upper neighbours, numbered as in cornerMasks(). At the end of the grid
// the first brick of the next row or plane, or one beyond the last, is read instead: its first
// nodes are outside, and only those are used, since the field's outermost nodes are 0.
SurfaceTracker::Above SurfaceTracker::above(const ColourField& field, std::int64_t brick) const {
  Above result;
  const std::int64_t alongY = field.brickDims().x(), alongZ = alongY * field.brickDims().y();
  for (int d = 0; d < 8; ++d) {
    result.mesh[d] = &meshOf(brick + (d & 1) + (d >> 1 & 1) * alongY + (d >> 2) * alongZ);
    result.inside[d] = result.mesh[d]->signs.inside;
  }
  return result;
}

// Aims at 390 instructions, many fewer where no cell is crossed.
RESECT_WIDEST
bool SurfaceTracker::findCrossings(const ColourField& field, std::int64_t brick) {
  const auto corners = cornerMasks(above(field, brick).inside);
  BrickMesh& mesh = meshOf(brick);
  const std::uint64_t cells = crossedCells(corners);
  mesh.wholeTriangles = 0;
  if (cells == 0) return mesh.signs.setCrossing(0, 0, 0);  // half of a liver's bricks
  mesh.wholeTriangles = std::int16_t(countTriangles(corners, cells));
  return mesh.signs.setCrossing(corners[0] ^ corners[1], corners[0] ^ corners[2],
                                corners[0] ^ corners[4]);
}

// Finds which edges shared with the bricks above are crossed. The neighbour along an axis shares
// those in the plane of its first nodes, the neighbour across an edge those on that edge.
template <typename Meshes>
[[gnu::always_inline]] inline SharedCrossings sharedCrossings(const Meshes& mesh) {
  const auto crossing = [&](std::size_t owner, std::size_t axis) {
    return mesh[owner]->signs.crossing[axis];
  };
  // Compacts two sets of edges to adjacent bits.
  constexpr std::uint64_t kFirstX = 0x1111111111111111, kFirstY = 0x000f000f000f000f;
  const auto pushBytes = [](std::uint64_t w) {
    w = (w | w >> 8) & 0x0000ffff0000ffff;
    return (w | w >> 16) & 0xffffffff;
  };
  std::uint64_t x = (crossing(1, 1) & kFirstX) | (crossing(1, 2) & kFirstX) << 1;
  x = (x | x >> 2) & 0x0f0f0f0f0f0f0f0f;
  x = pushBytes((x | x >> 4) & 0x00ff00ff00ff00ff);
  const std::uint64_t y = pushBytes((crossing(2, 0) & kFirstY) | (crossing(2, 2) & kFirstY) << 4);
  const std::uint64_t z = (crossing(4, 0) & 0xffff) | (crossing(4, 1) & 0xffff) << 16;
  // Gathers the four bits of an edge with one multiplication.
  const std::uint64_t alongX = crossing(6, 0) & 0xf,
                      alongY = (crossing(5, 1) & 0x1111) * 0x1248 >> 12 & 0xf,
                      alongZ =
                          (crossing(3, 2) & 0x0001000100010001) * 0x0001000200040008 >> 48 & 0xf;
  return {x | y << 32, z | alongX << 32 | alongY << 36 | alongZ << 40};
}

// Aims at 5 instructions for each vertex of the brick and 10 for each shared crossed edge, plus
// those of drawCells().
RESECT_WIDEST
void SurfaceTracker::drawTriangles(const ColourField& field, std::int64_t brick) {
  const Above around = above(field, brick);
  const BrickMesh& mesh = meshOf(brick);
  // The vertex on each edge that the brick's cells can use.
  EdgeTable table;
  const std::uint8_t* own = edges_.data() + mesh.firstVertex;
  for (int i = 0; i < mesh.signs.vertexCount(); i += CrossedEdges::kStep)
    for (int k = i; k < i + CrossedEdges::kStep; ++k)
      table.vertex[kOwnIndex[own[k]]] = mesh.firstVertex + k;
  const SharedCrossings crossings = sharedCrossings(around.mesh);
  std::array<std::uint8_t, kSharedEdges + 8> shared;
  const std::uint8_t* const end =
      appendSetBits(crossings[1], 64, appendSetBits(crossings[0], 0, shared.data()));
  for (const std::uint8_t* i = shared.data(); i != end; ++i) {
    const SharedEdge& edge = kSharedEdge[*i];
    const BrickMesh& owner = *around.mesh[edge.owner];
    table.vertex[edge.index] = owner.firstVertex + owner.signs.vertex(edge.axis, edge.node);
  }
  Triangle* out = triangles_.data() + mesh.firstTriangle;
  const Triangle* const limit = out + RangeAllocator::roundedUp(mesh.triangles);
  const auto corners = cornerMasks(around.inside);
  out = drawCells(table, cellKinds(corners), crossedCells(corners) & ~woundCells(mesh), out, limit);
  if (mesh.wound != kNone) drawWound(around, wounds_[std::size_t(mesh.wound)], table, out);
  out = triangles_.data() + mesh.firstTriangle + mesh.triangles;
  while (out < limit) *out++ = {0, 0, 0};
}

// Translates the corners of a wound's triangles, which are numbered by cell, to vertex indices.
void SurfaceTracker::drawWound(const Above& around, const BrickWound& wound, const EdgeTable& table,
                               Triangle* out) const {
  const auto vertex = [&](const BrickWound::Triangle& t, int corner) {
    const Vec3i cell(t.cell & 3, t.cell >> 2 & 3, t.cell >> 4);
    // The brick, among those above, that owns what lies at a node, 0 to 4 along each axis.
    const auto owner = [&](const Vec3i& n) -> const BrickMesh& {
      return *around.mesh[n.x() >> 2 | (n.y() >> 2) << 1 | (n.z() >> 2) << 2];
    };
    const auto number = [](const Vec3i& n) {
      return (n.x() & 3) | (n.y() & 3) << 2 | (n.z() & 3) << 4;
    };
    const auto ofWound = [&](const BrickMesh& mesh) {
      return mesh.firstVertex + mesh.signs.vertexCount();
    };
    if (corner >= kFirstCellVertex) return ofWound(*around.mesh[0]) + corner - kFirstCellVertex;
    if (corner >= kFirstFaceVertex) {
      const int face = (corner - kFirstFaceVertex) / 8, axis = face / 2;
      const Vec3i n = cell + face % 2 * Vec3i::Unit(axis);
      const BrickMesh& mesh = owner(n);
      return ofWound(mesh) + wounds_[std::size_t(mesh.wound)].faceVertex(
                                 axis, number(n), (corner - kFirstFaceVertex) % 8, t.lip);
    }
    if (corner % 3 == kIsoNode)
      return table.vertex[std::size_t(EdgeTable::ofCell(t.cell, corner / 3))];
    const CellEdge edge = kCellEdges[std::size_t(corner / 3)];
    const Vec3i n = cell + Vec3i(edge.from & 1, edge.from >> 1 & 1, edge.from >> 2);
    const BrickMesh& mesh = owner(n);
    return ofWound(mesh) +
           wounds_[std::size_t(mesh.wound)].edgeVertex(edge.axis, number(n), corner % 3);
  };
  for (const BrickWound::Triangle& t : wound.triangles)
    *out++ = {vertex(t, t.corners[0]), vertex(t, t.corners[1]), vertex(t, t.corners[2])};
}

}  // namespace resect
