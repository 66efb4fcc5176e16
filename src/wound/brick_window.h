// Dense windows of node values and severed edges round a brick, or round any box of nodes, for the
// rules of the wound.
#pragma once

#include "base/index_box.h"
#include "sph/colour_field.h"
#include "wound/cut_grid.h"

namespace resect {

// A brick with its halo: the nodes -2 to 6 along each axis, their values and the severed edges
// between them; outside the grid nodes are 0 and edges whole. Not copyable: `grid` points into it.
// Cost: some microseconds.
struct BrickWindow {
  static constexpr int kHalo = 2, kSide = 9, kNodes = kSide * kSide * kSide;

  std::array<float, kNodes> value;
  std::array<std::array<float, kNodes>, 3> severed;
  CutGrid grid;

  BrickWindow(const ColourField& field, const SeveredEdges& wound, const Vec3i& brick, float iso);
  BrickWindow(const BrickWindow&) = delete;
  BrickWindow& operator=(const BrickWindow&) = delete;

  // Index of a node given relative to the brick, each coordinate -2 to 6.
  static int index(const Vec3i& n) {
    return ((n.z() + kHalo) * kSide + n.y() + kHalo) * kSide + n.x() + kHalo;
  }
};

// The same for any box of nodes.
struct BoxWindow {
  std::vector<float> value;
  std::array<std::vector<float>, 3> severed;
  CutGrid grid;

  BoxWindow(const ColourField& field, const SeveredEdges& wound, const IndexBox& nodes, float iso);
  BoxWindow(const BoxWindow&) = delete;
  BoxWindow& operator=(const BoxWindow&) = delete;
};

}  // namespace resect
