// How are the triangles of a brick drawn, with vertices that it shares with the bricks above it?
#include <algorithm>
#include <array>
#include <bit>

#include "base/instruction_set.h"
#include "surface/marching_cubes_table.h"
#include "surface/surface_tracker.h"

namespace resect {
namespace {

// The nodes 0 to 4 of a brick along each axis, the last of them in the bricks above: x fastest.
constexpr int kSpan = kBrickNodes + 1, kSpanStep[3] = {1, kSpan, kSpan*kSpan};
constexpr int spanIndex(int x, int y, int z) { return (z * kSpan + y) * kSpan + x; }
constexpr int spanIndex(int node) { return spanIndex(node & 3, node >> 2 & 3, node >> 4); }

// The nodes of a brick that its neighbour below along an axis shares with it: those with 0 there.
constexpr std::uint64_t kFirstNodes[3] = {0x1111111111111111, 0x000f000f000f000f, 0xffff};

// For each edge of a cell: where it stands in a table of edges by axis and lower node, from the
// place of the cell's own node on.
constexpr std::array<int, 12> kEdgePlace = [] {
  std::array<int, 12> places{};
  for (std::size_t e = 0; e < 12; ++e) {
    const CellEdge& edge = kCellEdges[e];
    places[e] = edge.axis * kSpan * kSpan * kSpan +
                spanIndex(edge.from & 1, edge.from >> 1 & 1, edge.from >> 2);
  }
  return places;
}();

// marchingCubesTable() with those places instead of numbers of edges.
constexpr int kMostDrawn = 5, kMostlyDrawn = 3;  // triangles of a cell
struct DrawnCell {
  int count = 0;
  // Beyond `count` the first one again, so that it may be read.
  std::array<std::array<std::uint16_t, 3>, kMostDrawn> places{};
};

const std::array<DrawnCell, 256>& drawnCells() {
  static const auto cells = [] {
    std::array<DrawnCell, 256> all;
    for (std::size_t kind = 0; kind < 256; ++kind) {
      const CellTriangles& drawn = marchingCubesTable()[kind];
      all[kind].count = drawn.count;
      for (std::size_t t = 0; t < kMostDrawn; ++t)
        for (std::size_t v = 0; v < 3; ++v)
          all[kind].places[t][v] =
              std::uint16_t(kEdgePlace[drawn.edges[t < drawn.count ? t : 0][v]]);
    }
    return all;
  }();
  return cells;
}

}  // namespace

// The brick itself and its seven neighbours above, numbered as in cornerMasks().
SurfaceTracker::Above SurfaceTracker::above(const ColourField& field, std::int64_t brick) const {
  Above result;
  const Vec3i dims = field.brickDims();
  const std::int64_t alongY = dims.x(), alongZ = alongY * dims.y();
  const int beyond = meshOf(brick).last;
  for (int d = 0; d < 8; ++d) {
    const std::int64_t index = brick + (d & 1) + (d >> 1 & 1) * alongY + (d >> 2) * alongZ;
    result.mesh[d] = d & beyond ? &bricks_[kOutside] : &meshOf(index);
    result.inside[d] = result.mesh[d]->signs.inside;
  }
  return result;
}

RESECT_WIDEST
void SurfaceTracker::drawTriangles(const ColourField& field, std::int64_t brick) {
  const Above around = above(field, brick);
  const BrickMesh& mesh = meshOf(brick);
  // The vertex on each edge that the brick's cells can use: its own, and of the neighbours above
  // those in the plane, line or corner that they share with it.
  std::array<std::int32_t, 3 * kSpan * kSpan * kSpan> vertex;
  const auto onAxis = [&](int axis) { return vertex.data() + axis * kSpan * kSpan * kSpan; };
  for (int axis = 0; axis < 3; ++axis) {
    std::int32_t next = mesh.firstVertex + mesh.signs.firstVertex[std::size_t(axis)];
    for (std::uint64_t rest = mesh.signs.crossing[std::size_t(axis)]; rest != 0; rest &= rest - 1)
      onAxis(axis)[spanIndex(std::countr_zero(rest))] = next++;
  }
  for (int axis = 0; axis < 3; ++axis) {
    // The neighbour along an axis shares the edges along both others. Its nodes there have 0 along
    // the axis, so that the lower of that number's two bits may tell which of the two is meant.
    const BrickMesh& owner = *around.mesh[std::size_t(1) << axis];
    const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2, bit = 2 * axis;
    std::uint64_t rest = (owner.signs.crossing[std::size_t(u)] & kFirstNodes[axis]) |
                         (owner.signs.crossing[std::size_t(v)] & kFirstNodes[axis]) << (1 << bit);
    for (; rest != 0; rest &= rest - 1) {
      const int both = std::countr_zero(rest), second = both >> bit & 1;
      const int node = both - (second << bit), along = second ? v : u;
      onAxis(along)[spanIndex(node) + kBrickNodes * kSpanStep[axis]] =
          owner.firstVertex + owner.signs.vertex(along, node);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    // The neighbour across an edge shares the edges along it.
    const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    const BrickMesh& owner = *around.mesh[std::size_t(1 << u | 1 << v)];
    for (std::uint64_t rest =
             owner.signs.crossing[std::size_t(axis)] & kFirstNodes[u] & kFirstNodes[v];
         rest != 0; rest &= rest - 1) {
      const int node = std::countr_zero(rest);
      onAxis(axis)[spanIndex(node) + kBrickNodes * (kSpanStep[u] + kSpanStep[v])] =
          owner.firstVertex + owner.signs.vertex(axis, node);
    }
  }
  // How many triangles a cell has cannot be guessed: some are written always, and the next cell
  // writes over the surplus; not where the brick's range ends, for beyond lies another's.
  Triangle* end = triangles_.data() + mesh.firstTriangle;
  Triangle* const limit = end + RangeAllocator::roundedUp(mesh.triangles);
  const auto& cells = drawnCells();
  const auto corners = cornerMasks(around.inside);
  const CellKinds kinds = cellKinds(corners);
  for (std::uint64_t rest = crossedCells(corners) & ~woundCells(mesh); rest != 0;
       rest &= rest - 1) {
    const int cell = std::countr_zero(rest);
    const std::int32_t* at = vertex.data() + spanIndex(cell);
    const DrawnCell& own = cells[kinds[std::size_t(cell)]];
    const auto draw = [&](int t) {
      for (std::size_t v = 0; v < 3; ++v) end[t][v] = at[own.places[std::size_t(t)][v]];
    };
    int done = 0;
    if (limit - end >= kMostlyDrawn) {
      for (int t = 0; t < kMostlyDrawn; ++t) draw(t);
      done = kMostlyDrawn;
    }
    for (int t = done; t < own.count; ++t) draw(t);
    end += own.count;
  }
  if (mesh.wound != kNone) drawWound(around, wounds_[std::size_t(mesh.wound)], vertex.data(), end);
  end = triangles_.data() + mesh.firstTriangle + mesh.triangles;
  while (end < limit) *end++ = {0, 0, 0};
}

// A wound's triangles name their corners by cell; here they get numbers. onEdge: the table of
// drawTriangles().
void SurfaceTracker::drawWound(const Above& around, const BrickWound& wound,
                               const std::int32_t* onEdge, Triangle* out) const {
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
      return onEdge[spanIndex(t.cell) + kEdgePlace[std::size_t(corner / 3)]];
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
