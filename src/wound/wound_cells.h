// The surface of a cut organ inside one cell of the grid.
//
// The lines on the cell's six faces always link up to closed loops. Each loop is capped with
// triangles. A loop that consists of organ surface ("skin") alone keeps the triangles of the
// marching cubes table. The other loops are capped by fans: their skin parts round an apex on the
// skin, the rest round an inner apex. All loops of the cell share the inner apex, so the two lips
// of a cut coincide. The apex on the skin is placed so that the volume in the cell is the same as
// with the table's triangles. Cost: 1 to 2 us per cell.
#pragma once

#include <span>
#include <vector>

#include "wound/wound_loops.h"

namespace resect {

struct CellPoint {
  Vec3 position;          // in the window
  NearbyNodes anchors{};  // relative to the cell's lowest node
  bool skin = false;      // true: on the organ's surface; false: inside the organ
};

struct CellTriangle {
  std::array<CellVertex, 3> corners;
  bool skin;  // true: part of the organ's skin; false: part of a lip
};

// The result for one cell. It is reused from cell to cell, so that capping allocates nothing.
struct CellSurface {
  std::vector<CellPoint> points;
  std::vector<CellTriangle> triangles;
  CellLoops loops;
  bool unbalanced = false;  // the volume could not be kept: see capCell
};

// Whether the cell at node i needs the wound's rules. Tests all twelve edges.
bool isCutCell(const CutGrid& grid, int i);

// Caps the loops of the cell at node i. faces: the lines of the cell's faces; face number 2 * axis
// + side, side 0 for the lower one. The result is always closed. Its volume is that of the uncut
// cell, up to rounding, unless skin and lips are too small to correct it; then `unbalanced` is set.
void capCell(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces,
             CellSurface& out);

}  // namespace resect
