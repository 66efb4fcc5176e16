// The points of a wound's outline on one grid edge: where the edge is cut, and where it crosses the
// organ's surface.
//
// A severed edge inside tissue gives two points at the same position, one for each side of the cut.
// An edge that leaves the tissue gives one point, where the field has the iso level.
//
// An edge may leave the tissue and also be severed inside the tissue. Then the edge gives three
// points. The piece of the edge between the cut and the surface has no grid node of its own. It is
// assigned to an inside node near the edge. A path of whole (not severed) edges must lead from the
// edge's outside end to this node, and all other nodes of the path must be outside. If there are
// several such inside nodes, the node nearest to the edge's outside end is chosen. If pieces
// between cut and surface were left out, the two sides of a cut would have notches of up to one
// cell. In three cases such an edge gives only the point at the iso level:
// - The piece is at most 0.04 of the edge long.
// - No such inside node is found.
// - A face beside the edge is ambiguous: its corners are alternately inside and outside.
#pragma once

#include "wound/cut_grid.h"

namespace resect {

enum class EdgeKind : std::uint8_t {
  None,   // no point: both ends are outside, or both are inside and the edge is whole
  Iso,    // one point, where the surface crosses the edge
  Sheet,  // two points, at the cut
  Split   // three points: two at the cut, one where the surface crosses the edge
};

// The points of an edge. kLower: at the cut, on the side of the edge's lower end. kUpper: at the
// cut, on the side of the edge's upper end. kIsoNode: where the edge crosses the iso level.
enum EdgeNode : std::uint8_t { kLower = 0, kUpper = 1, kIsoNode = 2 };

struct CutEdge {
  EdgeKind kind = EdgeKind::None;
  bool lowerInside = false;
  bool open = false;   // severed outside tissue, or at most 0.04 edge lengths inside it
  float cut = kWhole;  // where it is severed, as a fraction from its lower end; or kWhole
  float iso = 0;       // for Iso and Split: where kIsoNode is, as a fraction from its lower end
  int owner = -1;      // for Iso and Split: the node of the CutGrid to which kIsoNode belongs

  bool cutsTissue() const { return kind == EdgeKind::Sheet || kind == EdgeKind::Split; }
};

// The points on the edge from node i of `grid` along the axis. The edge's upper node must be a node
// of `grid` too.
CutEdge cutEdge(const CutGrid& grid, int i, int axis);

// Whether the edge from node i along the axis is of kind Sheet or Split. The call is cheap if the
// edge is whole.
bool cutsTissue(const CutGrid& grid, int i, int axis);

}  // namespace resect
