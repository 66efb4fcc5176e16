// What lies in and round a brick of the colour field, side by side, for the rules of the wound?
#pragma once

#include "base/index_box.h"
#include "sph/colour_field.h"
#include "wound/cut_grid.h"

namespace resect {

// The nodes -2 to 6 of a brick along each axis, their values and the severed edges between them; 0
// and whole outside the grid. Not copied: `grid` points into it. Made in some microseconds.
struct BrickWindow {
  static constexpr int kHalo = 2, kSide = 9, kNodes = kSide * kSide * kSide;

  std::array<float, kNodes> value;
  std::array<std::array<float, kNodes>, 3> severed;
  CutGrid grid;

  BrickWindow(const ColourField& field, const SeveredEdges& wound, const Vec3i& brick, float iso);
  BrickWindow(const BrickWindow&) = delete;
  BrickWindow& operator=(const BrickWindow&) = delete;

  // Of a node of the brick, each coordinate -2 to 6.
  static int index(const Vec3i& n) {
    return ((n.z() + kHalo) * kSide + n.y() + kHalo) * kSide + n.x() + kHalo;
  }
};

// The same of any box of nodes.
struct BoxWindow {
  std::vector<float> value;
  std::array<std::vector<float>, 3> severed;
  CutGrid grid;

  BoxWindow(const ColourField& field, const SeveredEdges& wound, const IndexBox& nodes, float iso);
  BoxWindow(const BoxWindow&) = delete;
  BoxWindow& operator=(const BoxWindow&) = delete;
};

}  // namespace resect
