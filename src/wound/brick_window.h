// Dense arrays for a box of grid nodes: the values of the colour field at the nodes, and the
// severed edges between them. The code that meshes wounds reads these arrays. BrickWindow is for a
// brick, which is a block of 4 x 4 x 4 nodes, and the nodes around the brick. BoxWindow is for a
// box of any size.
#pragma once

#include "base/index_box.h"
#include "sph/colour_field.h"
#include "wound/cut_grid.h"

namespace resect {

// A brick with its halo: the nodes -2 to 6 along each axis, counted from the brick's first node,
// with their field values and the severed edges between them. Outside the colour field's grid, the
// values are 0 and the edges are whole (not severed). Not copyable, since `grid` points to the
// other members. Cost to make: some microseconds.
struct BrickWindow {
  static constexpr int kHalo = 2, kSide = 9, kNodes = kSide * kSide * kSide;

  std::array<float, kNodes> value;
  std::array<std::array<float, kNodes>, 3> severed;
  CutGrid grid;

  BrickWindow(const ColourField& field, const SeveredEdges& wound, const Vec3i& brick, float iso);
  BrickWindow(const BrickWindow&) = delete;
  BrickWindow& operator=(const BrickWindow&) = delete;

  // Index of a node. n: its coordinates relative to the brick's first node, each from -2 to 6.
  static int index(const Vec3i& n) {
    return ((n.z() + kHalo) * kSide + n.y() + kHalo) * kSide + n.x() + kHalo;
  }
};

// As BrickWindow, for any box of nodes.
struct BoxWindow {
  std::vector<float> value;
  std::array<std::vector<float>, 3> severed;
  CutGrid grid;

  BoxWindow(const ColourField& field, const SeveredEdges& wound, const IndexBox& nodes, float iso);
  BoxWindow(const BoxWindow&) = delete;
  BoxWindow& operator=(const BoxWindow&) = delete;
};

}  // namespace resect
