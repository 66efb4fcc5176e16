// Field values and severed edges in a window, for the code that meshes wounds. A window is a box of
// nodes of the colour field's grid: a brick (a block of 4 x 4 x 4 nodes) with a halo of two nodes,
// or any other box. In tests the window is the whole grid.
//
// A CutGrid points to arrays that another object holds. Nodes outside the window count as outside
// the tissue, and edges to them count as whole. Nodes are given by their index in the window.
// "Cell" here means a cell of the grid; its lowest node identifies it. The lower node and the axis
// identify an edge. The lowest node and the axis of the normal identify a face. Lengths are in node
// spacings. Positions are relative to the window's first node.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"
#include "wound/severed_edges.h"

namespace resect {

struct CutGrid {
  Vec3i first = Vec3i::Zero();  // the window's first node, in the colour field's grid
  Vec3i dims = Vec3i::Zero();   // number of nodes along each axis
  float iso = 50;
  const float* value = nullptr;  // field value per node, x fastest; a node is inside if >= iso
  // First index: axis of an edge. Second index: the edge's lower node. Value: position of the cut
  // along the edge, 0 to 1, or kWhole.
  std::array<const float*, 3> severed{};
  const SeveredEdges* wound = nullptr;  // the cuts with their normals; null: there are no cuts

  int stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? dims.x() : dims.x() * dims.y(); }
  int index(const Vec3i& n) const { return (n.z() * dims.y() + n.y()) * dims.x() + n.x(); }
  Vec3i node(int index) const {
    const int row = index / dims.x();
    return {index % dims.x(), row % dims.y(), row / dims.y()};
  }
  bool contains(const Vec3i& n) const {
    return (n.array() >= 0).all() && (n.array() < dims.array()).all();
  }
  bool inside(int i) const { return value[i] >= iso; }
  bool whole(int i, int axis) const { return severed[std::size_t(axis)][i] == kWhole; }
};

// The two axes that span a face whose normal is along `axis`. Let u be the unit vector along
// nextAxis(), and v along lastAxis(). As offsets from the face's node, the face's corners in order
// are 0, u, u + v and v.
constexpr int nextAxis(int axis) { return (axis + 1) % 3; }
constexpr int lastAxis(int axis) { return (axis + 2) % 3; }

// A set of nodes round a reference node r, as a mask: bit (z * 4 + y) * 4 + x stands for node r +
// (x, y, z) - (1, 1, 1), with x, y and z from 0 to 3.
using NearbyNodes = std::uint64_t;
constexpr NearbyNodes nearbyNode(int x, int y, int z) {
  return NearbyNodes(1) << (((z + 1) * 4 + y + 1) * 4 + x + 1);
}
inline NearbyNodes nearbyNode(const Vec3i& offset) {
  return nearbyNode(offset.x(), offset.y(), offset.z());
}
// Returns the same set of nodes as a mask round another reference node, which is one node lower
// along the axis. Nodes that the new mask cannot hold are dropped.
constexpr NearbyNodes seenFromBelow(NearbyNodes nodes, int axis) {
  return axis == 0   ? (nodes & 0x7777777777777777) << 1
         : axis == 1 ? (nodes & 0x0fff0fff0fff0fff) << 4
                     : nodes << 16;
}
// Calls visit(offset from the reference node) for each node of the set, from the lowest bit up.
template <typename Visit>
void visitNearby(NearbyNodes nodes, Visit visit) {
  for (; nodes != 0; nodes &= nodes - 1) {
    const int bit = std::countr_zero(nodes);
    visit(Vec3i((bit & 3) - 1, (bit >> 2 & 3) - 1, (bit >> 4) - 1));
  }
}

}  // namespace resect
