// The surface of a cut organ inside one cell of the grid.
//
// The lines on the cell's six faces always link to closed loops; each loop is capped with
// triangles. A loop of organ surface ("skin") alone keeps the triangles of the marching cubes
// table. Other loops are capped by fans: their skin parts round an apex on the skin, the rest round
// an inner apex that all loops of the cell share, so that the two lips of a cut coincide. The
// skin's apex is placed so that the cell's volume equals that of the uncut table. Cost: 1-2 us.
#pragma once

#include <span>
#include <vector>

#include "wound/wound_loops.h"

namespace resect {

struct CellPoint {
  Vec3 position;          // in the window
  NearbyNodes anchors{};  // nodes of its piece of tissue
  bool skin = false;      // on the organ's surface, not inside
};

struct CellTriangle {
  std::array<CellVertex, 3> corners;
  bool skin;  // part of the organ's skin; else of a lip
};

// Reused from cell to cell, so that capping allocates nothing.
struct CellSurface {
  std::vector<CellPoint> points;
  std::vector<CellTriangle> triangles;
  CellLoops loops;
  bool unbalanced = false;  // the volume could not be kept: see capCell
};

// Whether the cell at node i needs the wound's rules. Tests all twelve edges.
bool isCutCell(const CutGrid& grid, int i);

// faces: the lines of the cell's faces, by number. The result is always closed. The volume is kept,
// up to rounding, unless neither skin nor lips have the area for it: then `unbalanced` is set.
void capCell(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces,
             CellSurface& out);

}  // namespace resect
