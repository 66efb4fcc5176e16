// The surface of a cut organ inside one cell of the grid.
//
// The surface meets the six faces of the cell in lines (wound/wound_faces.h). These lines always
// form closed loops. Each loop is capped with triangles. A loop that no cut touches bounds only the
// organ's surface ("skin"). Such a loop gets the triangles of the marching cubes table. Any other
// loop is capped by fans of triangles. The part of the loop that is skin gets a fan round an apex
// on the skin. The rest of the loop gets a fan round an inner apex; in simple cells, one of the
// loop's own vertices is the apex instead. All loops of the cell have the same inner apex, so the
// two lips (sides) of a cut coincide. The apex on the skin is placed so that the tissue in the cell
// has the same volume as it would have with the triangles of the table. Cost: 1 to 2 us per cell.
#pragma once

#include <span>
#include <vector>

#include "wound/wound_loops.h"

namespace resect {

struct CellPoint {
  Vec3 position;          // in the coordinates of the CutGrid's nodes
  NearbyNodes anchors{};  // relative to the cell's lowest node
  bool skin = false;      // true: on the organ's surface; false: inside the organ
};

struct CellTriangle {
  std::array<CellVertex, 3> corners;
  bool skin;  // true: part of the organ's skin; false: part of a lip
};

// The result for one cell. One object is used for one cell after another, so that capping allocates
// nothing.
struct CellSurface {
  std::vector<CellPoint> points;
  std::vector<CellTriangle> triangles;
  CellLoops loops;
  bool unbalanced = false;  // true: the volume could not be kept; see capCell()
};

// Whether a cut goes through tissue on one of the twelve edges of the cell with lowest node i. If
// so, the cell is meshed by capCell().
bool isCutCell(const CutGrid& grid, int i);

// Caps the loops of the cell with lowest node i. faces: the lines on the faces of the cell. Face
// number 2 * axis + side is the lower (side 0) or upper (side 1) face along the axis. The triangles
// always close all loops. The volume of the tissue is the same as in the uncut cell, up to
// rounding. If skin and lips are too small to correct the volume, `unbalanced` is set.
void capCell(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces,
             CellSurface& out);

}  // namespace resect
