// How does a grid edge meet the surface and the blade?
//
// An edge within tissue that is severed gives two nodes of the surface, one a side, at one place.
// An edge that leaves the tissue gives one node where it crosses the iso level. If it is severed
// below that, it gives three: the piece between cut and skin has no corner of its own and goes with
// the inside corner found by walking on outside, over whole edges. Without it lips would be notched
// by up to a cell.
#pragma once

#include "wound/cut_grid.h"

namespace resect {

enum class EdgeKind : std::uint8_t {
  None,   // no node: both ends outside, or both inside and whole
  Iso,    // one node, where the surface crosses
  Sheet,  // two nodes, at the cut
  Split   // three nodes: two at the cut, one where the surface crosses
};

// The nodes of an edge: at the cut, on the side of its lower and of its upper end; at the iso
// level.
enum EdgeNode : std::uint8_t { kLower = 0, kUpper = 1, kIsoNode = 2 };

struct CutEdge {
  EdgeKind kind = EdgeKind::None;
  bool lowerInside = false;
  bool open = false;   // severed outside the tissue
  float cut = kWhole;  // share of the edge below the cut
  float iso = 0;       // share of the edge below the iso node
  int owner = -1;      // Iso, Split: the node of the grid that the iso node goes with

  bool cutsTissue() const { return kind == EdgeKind::Sheet || kind == EdgeKind::Split; }
};

// The edge from node i along the axis; its upper node must lie in the window.
CutEdge cutEdge(const CutGrid& grid, int i, int axis);

// Is the edge of kind Sheet or Split? Cheaper where the answer is no.
bool cutsTissue(const CutGrid& grid, int i, int axis);

}  // namespace resect
