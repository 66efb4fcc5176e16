// What does the surface of a cut organ look like inside one cell of the grid?
//
// The lines on the cell's six faces link to closed loops, whatever was cut; each loop is capped. A
// loop of skin alone keeps the triangles of the marching-cubes table. The others are capped by
// fans: skin stretches round an apex on the skin, the rest round an apex within, at one place for
// all loops of the cell, so that the two lips of a cut lie on each other. The apex on the skin is
// put where the cell's volume is exactly that of the uncut table. Cost: 1-2 us.
#pragma once

#include <span>
#include <vector>

#include "wound/wound_loops.h"

namespace resect {

struct CellPoint {
  Vec3 position;          // in the window
  NearbyNodes anchors{};  // nodes of the grid that it goes with
  bool skin = false;      // on the organ's skin, not within
};

struct CellTriangle {
  std::array<CellVertex, 3> corners;
  bool skin;  // part of the organ's skin; else of a lip
};

// Kept from cell to cell, so that capping allocates nothing.
struct CellSurface {
  std::vector<CellPoint> points;
  std::vector<CellTriangle> triangles;
  CellLoops loops;
  bool unbalanced = false;  // the volume could not be kept: see capCell
};

// Does the cell at node i need the wound's rule? Asks all twelve edges.
bool isCutCell(const CutGrid& grid, int i);

// faces: the lines of the cell's faces, by number. Always closes. The volume is kept, up to
// rounding, unless neither skin nor lips have any area to hold it: then `unbalanced` is set.
void capCell(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces,
             CellSurface& out);

}  // namespace resect
