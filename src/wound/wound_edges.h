// How a grid edge meets the surface and a cut: the points of the wound's outline on it.
//
// A severed edge inside tissue gives two points, one for each side, at the same position. An edge
// that leaves the tissue gives one point where it crosses the iso level. If such an edge is severed
// inside the tissue, more than 0.04 of it from the surface, it gives three, unless it is beside an
// ambiguous face or no node is found for the piece: the piece between cut and surface has no grid
// node of its own and goes with the nearest inside node found over whole edges outside the tissue.
// Without that piece lips would be notched by up to a cell.
#pragma once

#include "wound/cut_grid.h"

namespace resect {

enum class EdgeKind : std::uint8_t {
  None,   // no point: both ends outside, or both inside and whole
  Iso,    // one point, where the surface crosses
  Sheet,  // two points, at the cut
  Split   // three points: two at the cut, one where the surface crosses
};

// The points of an edge: at the cut, on the side of its lower and of its upper end; at the iso
// level.
enum EdgeNode : std::uint8_t { kLower = 0, kUpper = 1, kIsoNode = 2 };

struct CutEdge {
  EdgeKind kind = EdgeKind::None;
  bool lowerInside = false;
  bool open = false;   // severed outside the tissue, or next to its surface
  float cut = kWhole;  // fraction of the edge below the cut
  float iso = 0;       // fraction of the edge below the iso point
  int owner = -1;      // Iso, Split: the grid node that the iso point goes with

  bool cutsTissue() const { return kind == EdgeKind::Sheet || kind == EdgeKind::Split; }
};

// The edge from node i along the axis; its upper node must lie in the window.
CutEdge cutEdge(const CutGrid& grid, int i, int axis);

// Whether the edge is of kind Sheet or Split. Cheap if it is not.
bool cutsTissue(const CutGrid& grid, int i, int axis);

}  // namespace resect
