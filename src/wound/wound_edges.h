// How a grid edge meets the surface and a cut: the points of the wound's outline on it.
//
// A severed edge inside tissue gives two points, one for each side, at the same position. An edge
// that leaves the tissue gives one point, where it crosses the iso level. If such an edge is
// severed inside the tissue as well, the piece between the cut and the surface has no grid node of
// its own. It goes with the nearest inside node that is reached over whole edges outside the
// tissue, and the edge gives three points. Without this piece lips would be notched by up to a
// cell. In three cases the edge gives one point only: the piece is at most 0.04 of the edge long,
// no such node is found, or the edge is beside an ambiguous face (its corners are alternately
// inside and outside).
#pragma once

#include "wound/cut_grid.h"

namespace resect {

enum class EdgeKind : std::uint8_t {
  None,   // no point: both ends outside, or both inside and the edge whole
  Iso,    // one point, where the surface crosses
  Sheet,  // two points, at the cut
  Split   // three points: two at the cut, one where the surface crosses
};

// The points of an edge: at the cut on the side of the edge's lower end, at the cut on the side of
// its upper end, and at the iso level.
enum EdgeNode : std::uint8_t { kLower = 0, kUpper = 1, kIsoNode = 2 };

struct CutEdge {
  EdgeKind kind = EdgeKind::None;
  bool lowerInside = false;
  bool open = false;   // severed outside the tissue, or just inside its surface
  float cut = kWhole;  // fraction of the edge from its lower end to the cut
  float iso = 0;       // fraction of the edge from its lower end to the iso point
  int owner = -1;      // Iso, Split: the grid node that the iso point goes with

  bool cutsTissue() const { return kind == EdgeKind::Sheet || kind == EdgeKind::Split; }
};

// The edge from node i along the axis; its upper node must lie in the window.
CutEdge cutEdge(const CutGrid& grid, int i, int axis);

// Whether the edge is of kind Sheet or Split. Cheap for a whole edge.
bool cutsTissue(const CutGrid& grid, int i, int axis);

}  // namespace resect
